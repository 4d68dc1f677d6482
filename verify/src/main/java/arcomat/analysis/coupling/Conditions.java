package arcomat.analysis.coupling;

import arcomat.model.Port;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/** For each pair of states that is thought to be reachable, what is so of variables there. */
record Conditions(Map<StatePair, List<Comparison>> byPair) {
    /** Empty where the pair is not to be reached. */
    Optional<List<Comparison>> at(StatePair pair) {
        return Optional.ofNullable(byPair.get(pair));
    }

    /** Variables that some condition is about. */
    List<Port> variables() {
        return byPair.values().stream()
                .flatMap(List::stream)
                .flatMap(Comparison::variables)
                .distinct()
                .toList();
    }
}
