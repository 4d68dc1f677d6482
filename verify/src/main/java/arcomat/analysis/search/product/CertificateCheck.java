package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.product.Certificate.Entry;
import arcomat.analysis.search.step.CubeSplit;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Port;

import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Verifies a certificate, without any search: each beginning is in a pair of the certificate, and
 * each step out of such a pair leads to one again. Knows what letters and steps are, and nothing of
 * how the pairs were found.
 */
public final class CertificateCheck {
    private static final int NAMED_PAIRS = 3;

    private record Pair(int left, Set<Integer> right) {}

    private final Product product;
    private final Budget budget;
    private final Map<String, List<Set<String>>> entries = new HashMap<>();
    private final Deque<Pair> open = new ArrayDeque<>();
    private final Set<Pair> met = new HashSet<>();
    private @Nullable String problem;

    /**
     * @param budget of time and memory
     */
    public CertificateCheck(
            TransitionSystem left,
            TransitionSystem right,
            List<Port> observed,
            OutputCubes outputs,
            Certificate certificate,
            Budget budget) {
        this.budget = budget;
        this.product = new Product(left, right, observed, outputs, budget);
        for (Entry entry : certificate.entries()) {
            entries.computeIfAbsent(entry.left(), each -> new ArrayList<>())
                    .add(new HashSet<>(entry.right()));
        }
    }

    /** What is missing; empty for a proof. */
    public Optional<String> problem() {
        Steps theirs = product.right.openings();
        leads("the beginning", product.left.openings(), theirs);
        while (problem == null && !open.isEmpty()) {
            budget.insist();
            verify(open.remove());
        }
        return Optional.ofNullable(problem).or(product.left::leftOut).or(product::missing);
    }

    private void verify(Pair pair) {
        int set = product.sets.number(pair.right.stream().mapToInt(each -> each).toArray());
        Alphabet alphabet = product.alphabet(pair.left, set);
        Steps[] mine = product.leftSteps(pair.left, alphabet);
        for (int letter = 0; letter < mine.length && problem == null; letter++) {
            leads(name(pair), mine[letter], product.answers(set, alphabet, letter));
        }
    }

    /** Whether each step is allowed, and leads to a pair of the certificate. */
    private void leads(String from, Steps mine, Steps theirs) {
        for (int step = 0; step < mine.size(); step++) {
            for (CubeSplit.Case sent : product.cases(mine.outputs()[step], theirs)) {
                if (sent.allowed().length == 0) {
                    problem = "a step out of %s is forbidden".formatted(from);
                    return;
                }
                Set<Integer> next = new HashSet<>();
                for (int allowed : sent.allowed()) {
                    next.add(theirs.next()[allowed]);
                }
                if (next.stream().noneMatch(product::isSettled)
                        && !covers(mine.next()[step], next)) {
                    problem =
                            "a step out of %s leads to %s, which is in no pair"
                                    .formatted(from, name(new Pair(mine.next()[step], next)));
                    return;
                }
            }
        }
    }

    /** Goes on from the pair of the certificate, which may have fewer possibilities. */
    private boolean covers(int left, Set<Integer> right) {
        Map<String, Integer> names = new HashMap<>();
        right.forEach(each -> names.put(product.right.name(each), each));
        for (Set<String> entry : entries.getOrDefault(product.left.name(left), List.of())) {
            if (!entry.isEmpty() && names.keySet().containsAll(entry)) {
                Set<Integer> members = new HashSet<>();
                entry.forEach(each -> members.add(names.get(each)));
                Pair pair = new Pair(left, members);
                if (met.add(pair)) {
                    open.add(pair);
                }
                return true;
            }
        }
        return false;
    }

    private String name(Pair pair) {
        List<String> right =
                pair.right.stream().limit(NAMED_PAIRS).map(product.right::describe).toList();
        return "(%s; %s)".formatted(product.left.describe(pair.left), String.join(" or ", right));
    }
}
