package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.search.Moment;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Refusal;
import arcomat.model.Refusal.Truth;
import arcomat.model.Trace;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.automaton.WhyNot;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Goes the way of every witness with the step relation alone, and sees at its end what was found.
 */
final class Replay {
    private final Automaton automaton;
    private final Component component;
    private final StepRelation relation;

    private Replay(Examination examination) {
        automaton = examination.automaton();
        component = examination.component();
        relation =
                ComponentSemantics.of(
                                component, List.of(automaton), examination.promise().arguments())
                        .relations()
                        .get(0);
    }

    static void all(Examination examination) {
        for (Finding finding : examination.findings()) {
            if (!finding.trace().isEmpty()) {
                new Replay(examination).replay(finding);
            }
        }
    }

    private void replay(Finding finding) {
        Set<Configuration> reached = beginnings(finding.trace().get(0));
        for (Moment moment : finding.trace().subList(1, finding.trace().size())) {
            assertLegal(moment.input());
            reached = after(reached, moment);
        }
        assertThat(reached).as("ends of the run of %s", finding).isNotEmpty();
        finding.witness().ifPresent(this::assertLegal);
        assertThat(reached)
                .as(finding.toString())
                .anyMatch(configuration -> shows(finding, configuration));
    }

    private Set<Configuration> beginnings(Moment first) {
        Set<Configuration> found = new HashSet<>();
        relation.starts().stream()
                .filter(start -> sent(start.output()).equals(first.outputs()))
                .forEach(start -> found.add(start.configuration()));
        return found;
    }

    private Set<Configuration> after(Set<Configuration> before, Moment moment) {
        Set<Configuration> found = new HashSet<>();
        for (Configuration configuration : before) {
            for (Reaction reaction : reactions(configuration, moment.input())) {
                if (sent(reaction.output()).equals(moment.outputs())
                        && moment.left().equals(words(reaction.next()))) {
                    found.add(reaction.next());
                }
            }
        }
        return found;
    }

    /** Of the transitions that go well. */
    private List<Reaction> reactions(Configuration configuration, Letter letter) {
        Input input = Input.of(component, letter);
        List<Reaction> reactions = new ArrayList<>();
        for (Trace.Taken taken : relation.choices(configuration, input).enabled()) {
            try {
                reactions.add(relation.take(taken, configuration, input));
            } catch (Fault alternativeGoesWrong) {
                continue;
            }
        }
        return reactions;
    }

    private String words(Configuration configuration) {
        String values =
                IntStream.range(0, configuration.variables().size())
                        .mapToObj(
                                i ->
                                        automaton.variables().get(i).name()
                                                + " = "
                                                + configuration.variables().get(i))
                        .collect(Collectors.joining(", "));
        String state = automaton.states().get(configuration.state());
        return values.isEmpty() ? state : state + " (" + values + ")";
    }

    private Map<String, Sent> sent(Output output) {
        Map<String, Sent> sent = new java.util.LinkedHashMap<>();
        for (int i = 0; i < component.outputs().size(); i++) {
            sent.put(component.outputs().get(i).name(), output.ports().get(i));
        }
        return sent;
    }

    /** Messages fit their ports, and total ports carry one. */
    private void assertLegal(Letter letter) {
        for (Port port : component.inputs()) {
            Optional<arcomat.model.Value> message = letter.message(port.name());
            assertThat(port.total() && message.isEmpty()).as("%s of %s", port, letter).isFalse();
            if (message.isPresent()
                    && port.type() instanceof arcomat.model.Type.IntegerType integer) {
                long value = ((arcomat.model.Value.IntegerValue) message.get()).value();
                assertThat(value).isBetween(integer.low(), integer.high());
            }
        }
    }

    private boolean shows(Finding finding, Configuration configuration) {
        if (finding.code().equals(Trap.CODE) || finding.code().equals(IntegerOverflow.CODE)) {
            return true; // not to be seen in one step, or not in values that have wrapped around
        }
        Input input = Input.of(component, finding.witness().orElseThrow());
        if (finding.code().equals(Overlap.CODE)) {
            return relation.choices(configuration, input).enabled().size() > 1;
        }
        if (finding.code().equals(Completeness.CODE)
                || finding.code().equals(VacuousOnSilence.CODE)) {
            return relation.enabled(configuration, input).isEmpty();
        }
        if (finding.code().equals(ForgottenSilence.CODE)) {
            return relation.enabled(configuration, input).isEmpty()
                    && WhyNot.of(relation).refusals(configuration, input).stream()
                            .anyMatch(refusal -> lacksOnlyMessages(refusal, finding));
        }
        return fails(configuration, input);
    }

    /** Undefined, and not false: among them the part of the guard that is pointed at. */
    private static boolean lacksOnlyMessages(Refusal refusal, Finding finding) {
        return refusal.failed().stream().allMatch(each -> each.truth() == Truth.UNDEFINED)
                && refusal.failed().stream()
                        .anyMatch(
                                each ->
                                        finding.diagnostic()
                                                .message()
                                                .startsWith("'" + each.text() + "' never holds"));
    }

    private boolean fails(Configuration configuration, Input input) {
        try {
            StepRelation.Choices choices = relation.choices(configuration, input);
            choices.enabled().forEach(taken -> relation.take(taken, configuration, input));
            return !choices.faults().isEmpty();
        } catch (Fault fault) {
            return true;
        }
    }
}
