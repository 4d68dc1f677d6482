package arcomat.analysis.symbolic;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Checks a refutation: each conclusion has to follow from the clauses before it by unit propagation
 * (Goldberg, Novikov, "Verification of proofs of unsatisfiability for CNF formulas", DATE 2003).
 */
final class UnitPropagation {
    /** Per literal, the clauses that watch it: of each clause, two literals that may be true. */
    private final List<List<int[]>> watching = new ArrayList<>();

    /** Per literal. */
    private boolean[] isTrue = {};

    /** Per literal, while a clause is read. */
    private boolean[] isMet = {};

    private final IntArrayList trail = new IntArrayList();
    private int done;

    /** What has been shown to be wrong whatever is assumed. */
    private boolean refuted;

    /** What it has been told. */
    private int clausesTold;

    private int conclusionsTold;

    /**
     * Whether the conclusions follow one after the other, and the last one cannot be. More clauses
     * and conclusions may come after each question.
     */
    boolean refutes(Clauses clauses, List<int[]> conclusions, Runnable between) {
        return accepts(clauses, conclusions, between) && refuted;
    }

    /** Whether the conclusions follow, and from them that some literals cannot all be true. */
    boolean excludes(Clauses clauses, List<int[]> conclusions, int[] literals, Runnable between) {
        return accepts(clauses, conclusions, between)
                && follows(Arrays.stream(literals).map(literal -> -literal).toArray());
    }

    private boolean accepts(Clauses clauses, List<int[]> conclusions, Runnable between) {
        grow(2 * clauses.variables() + 2);
        for (; clausesTold < clauses.all().size(); clausesTold++) {
            add(clauses.all().get(clausesTold));
        }
        for (; conclusionsTold < conclusions.size() && !refuted; conclusionsTold++) {
            between.run();
            if (!follows(conclusions.get(conclusionsTold))) {
                return false;
            }
            add(conclusions.get(conclusionsTold));
        }
        return true;
    }

    private void grow(int literals) {
        isTrue = Arrays.copyOf(isTrue, Math.max(isTrue.length, literals));
        isMet = Arrays.copyOf(isMet, isTrue.length);
        while (watching.size() < literals) {
            watching.add(new ArrayList<>());
        }
    }

    private static int place(int literal) {
        return literal > 0 ? 2 * literal : -2 * literal + 1;
    }

    private boolean isTrue(int literal) {
        return isTrue[place(literal)];
    }

    private boolean isFalse(int literal) {
        return isTrue[place(literal) ^ 1];
    }

    /** Whether the contrary leads to a contradiction. */
    private boolean follows(int[] clause) {
        int start = trail.size();
        boolean contradicts = refuted;
        for (int literal : clause) {
            contradicts |= isTrue(literal);
            if (!contradicts && !isFalse(literal)) {
                assume(-literal);
            }
        }
        contradicts = contradicts || !propagate();
        for (int i = start; i < trail.size(); i++) {
            isTrue[place(trail.get(i))] = false;
        }
        trail.elementsCount = start;
        done = start;
        return contradicts;
    }

    private void assume(int literal) {
        isTrue[place(literal)] = true;
        trail.add(literal);
    }

    private void add(int[] clause) {
        int[] own = distinct(clause);
        int free = 0;
        for (int i = 0; i < own.length && free < 2; i++) {
            if (!isFalse(own[i])) {
                int literal = own[free];
                own[free++] = own[i];
                own[i] = literal;
            }
        }
        if (free == 0) {
            refuted = true;
        } else if (free == 2) {
            watching.get(place(own[0])).add(own);
            watching.get(place(own[1])).add(own);
        } else if (!isTrue(own[0])) {
            assume(own[0]);
            refuted |= !propagate();
        }
    }

    /** Its literals, each once: two places of one literal are no two that may be true. */
    private int[] distinct(int[] clause) {
        int[] own = new int[clause.length];
        int size = 0;
        for (int literal : clause) {
            if (!isMet[place(literal)]) {
                isMet[place(literal)] = true;
                own[size++] = literal;
            }
        }
        for (int i = 0; i < size; i++) {
            isMet[place(own[i])] = false;
        }
        return size == own.length ? own : Arrays.copyOf(own, size);
    }

    /** Whether all clauses can still be true. */
    private boolean propagate() {
        while (done < trail.size()) {
            int wrong = -trail.get(done++);
            List<int[]> all = watching.get(place(wrong));
            int kept = 0;
            boolean possible = true;
            for (int i = 0; i < all.size(); i++) {
                int[] clause = all.get(i);
                boolean stays = !possible || stays(clause, wrong);
                if (stays) {
                    all.set(kept++, clause);
                    possible = possible && !isFalse(clause[0]);
                }
            }
            all.subList(kept, all.size()).clear();
            if (!possible) {
                return false;
            }
        }
        return true;
    }

    /** Whether a clause goes on watching what is false now; its first literal is true then. */
    private boolean stays(int[] clause, int wrong) {
        if (clause[0] == wrong) {
            clause[0] = clause[1];
            clause[1] = wrong;
        }
        if (isTrue(clause[0])) {
            return true;
        }
        for (int i = 2; i < clause.length; i++) {
            if (!isFalse(clause[i])) {
                clause[1] = clause[i];
                clause[i] = wrong;
                watching.get(place(clause[1])).add(clause);
                return false;
            }
        }
        if (!isFalse(clause[0])) {
            assume(clause[0]);
        }
        return true;
    }
}
