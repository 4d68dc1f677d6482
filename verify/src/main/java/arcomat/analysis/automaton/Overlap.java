package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.automaton.exploration.Situation.Alternative;
import arcomat.analysis.reachability.Subject;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Two transitions that are enabled together. The worst that a pair can do counts: different outputs
 * are seen from outside, a different target with equal outputs is hidden.
 */
final class Overlap extends Analysis {
    static final String CODE = "ARC1001";

    /** The worst first. */
    private enum Kind {
        OBSERVABLE,
        HIDDEN,
        SAME_EFFECT
    }

    private record Pair(int first, int second, Kind kind) implements Comparable<Pair> {
        private static final Comparator<Pair> ORDER =
                Comparator.comparingInt(Pair::first)
                        .thenComparingInt(Pair::second)
                        .thenComparing(Pair::kind);

        @Override
        public int compareTo(Pair other) {
            return ORDER.compare(this, other);
        }
    }

    private final SortedMap<Pair, Situation> overlaps = new TreeMap<>();

    Overlap(Subject subject) {
        super(subject);
    }

    @Override
    void see(Situation situation) {
        List<Alternative> all = situation.alternatives();
        for (int i = 0; i < all.size(); i++) {
            for (int j = i + 1; j < all.size(); j++) {
                Alternative one = all.get(i);
                Alternative two = all.get(j);
                Pair pair = new Pair(one.taken().index(), two.taken().index(), kind(one, two));
                overlaps.merge(pair, situation, Situation::simpler);
            }
        }
    }

    private static Kind kind(Alternative one, Alternative two) {
        if (one.reaction().isEmpty() || two.reaction().isEmpty()) {
            return Kind.OBSERVABLE;
        }
        Reaction first = one.reaction().get();
        Reaction second = two.reaction().get();
        if (!first.output().equals(second.output())) {
            return Kind.OBSERVABLE;
        }
        return first.next().equals(second.next()) ? Kind.SAME_EFFECT : Kind.HIDDEN;
    }

    @Override
    List<Finding> findings(Knowledge knowledge) {
        List<Finding> findings = new ArrayList<>();
        Pair last = null;
        for (Map.Entry<Pair, Situation> entry : overlaps.entrySet()) {
            Pair pair = entry.getKey();
            boolean lesser = last != null && last.first == pair.first && last.second == pair.second;
            if (!lesser) {
                findings.add(finding(pair, entry.getValue()));
            }
            last = pair;
        }
        return findings;
    }

    private Finding finding(Pair pair, Situation situation) {
        Diagnostic diagnostic =
                Diagnostic.warning(
                                CODE,
                                subject.transition(pair.first).span(),
                                "in %s two transitions are enabled, %s"
                                        .formatted(words(situation), difference(pair, situation)))
                        .withRelated(
                                subject.transition(pair.second).span(),
                                "this one is enabled as well");
        return finding(diagnostic, situation);
    }

    private String difference(Pair pair, Situation situation) {
        Alternative one = find(pair.first, situation);
        Alternative two = find(pair.second, situation);
        return switch (pair.kind) {
            case OBSERVABLE -> "and what is sent differs: %s or %s".formatted(sent(one), sent(two));
            case HIDDEN ->
                    "and send the same, but lead to different configurations: %s or %s"
                            .formatted(target(one), target(two));
            case SAME_EFFECT -> "with the same effect: one of them is enough";
        };
    }

    private static Alternative find(int transition, Situation situation) {
        return situation.alternatives().stream()
                .filter(each -> each.taken().index() == transition)
                .findFirst()
                .orElseThrow();
    }

    private String sent(Alternative alternative) {
        return alternative
                .reaction()
                .map(reaction -> words(reaction.output()))
                .orElse("a run error");
    }

    private String target(Alternative alternative) {
        return words(alternative.reaction().orElseThrow().next());
    }
}
