package arcomat.analysis.coverage;

import arcomat.analysis.reachability.Preconditions;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.letter.Representatives;
import arcomat.analysis.smt.DataStep;
import arcomat.analysis.smt.KnownExamples;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.value.TooManyMessages;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Letters of a component that calculates with messages of too many values to try: one for each way
 * in which its steps differ.
 */
final class CalculatedLetters {
    private final ComponentSemantics behaviour;
    private final List<List<Preconditions>> preconditions;
    private final KnownExamples examples;

    /**
     * @param behaviour of a time-synchronous component
     * @param stop asked now and then, whether to give up
     */
    CalculatedLetters(ComponentSemantics behaviour, BooleanSupplier stop) {
        this.behaviour = behaviour;
        this.examples = new KnownExamples(stop);
        this.preconditions =
                behaviour.relations().stream()
                        .map(
                                relation ->
                                        Preconditions.of(
                                                Component.Profile.TIME_SYNCHRONOUS,
                                                relation.automaton()))
                        .toList();
    }

    /** All that are told apart; empty where that is not known, or they are more than so many. */
    Optional<List<Value[]>> of(List<Configuration> configurations, int most) {
        List<DataStep> steps = new ArrayList<>();
        for (int i = 0; i < configurations.size(); i++) {
            steps.addAll(
                    DataStep.outOf(
                            configurations.get(i),
                            behaviour.relations().get(i),
                            preconditions.get(i)));
        }
        List<Port> ports = behaviour.component().inputs();
        try {
            Alphabet all =
                    new Alphabet(
                            Component.Profile.TIME_SYNCHRONOUS,
                            ports,
                            List.of(
                                    new LetterClasses(
                                            0, behaviour.abstraction(configurations), ports)),
                            List.of(IntStream.range(0, ports.size()).toArray()),
                            Representatives.NONE,
                            Optional.of(examples.of(steps)));
            return all.missing().isPresent() || all.size() > most
                    ? Optional.empty()
                    : Optional.of(IntStream.range(0, all.size()).mapToObj(all::letter).toList());
        } catch (TooManyMessages problem) {
            return Optional.empty();
        }
    }
}
