package arcomat.simulate.run;

import arcomat.model.Automaton;
import arcomat.model.Port;
import arcomat.model.Refusal;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.automaton.WhyNot;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** One instance as it runs: where its automata are, and how they go on. */
final class Actor {
    private final Network.Instance instance;
    private final ComponentSemantics behaviour;
    private final List<StepRelation> relations;
    private final List<Port> outputs;
    private final Choice choice;
    private final Optional<List<WhyNot>> whyNot;
    private List<Configuration> configurations = List.of();

    /**
     * @param whyNot one per automaton, where a run tells why no transition was enabled
     */
    Actor(
            Network.Instance instance,
            ComponentSemantics behaviour,
            Choice choice,
            Optional<List<WhyNot>> whyNot) {
        this.instance = instance;
        this.behaviour = behaviour;
        this.relations = behaviour.relations();
        this.outputs = instance.component().outputs();
        this.choice = choice;
        this.whyNot = whyNot;
    }

    Network.Instance instance() {
        return instance;
    }

    /**
     * Takes an initial clause.
     *
     * @return per output port the messages of the initial output
     */
    List<List<Value>> start() {
        try {
            return begin();
        } catch (ModelError problem) {
            throw at(instance, problem);
        }
    }

    private List<List<Value>> begin() {
        List<JointStart> starts = behaviour.starts();
        if (starts.isEmpty()) {
            throw contradiction("to begin with");
        }
        JointStart start =
                pick(starts, 0, s -> Descriptions.of(relations, s, instance.component()));
        configurations = start.configurations();
        return messages(start.output());
    }

    /**
     * Reacts to an input and notes what each automaton did.
     *
     * @return per output port the messages to send
     */
    List<List<Value>> react(Input input, int step, List<Trace.Activity> activities) {
        try {
            return goOn(input, step, activities);
        } catch (ModelError problem) {
            throw at(instance, problem);
        }
    }

    /** A problem, with the path of the instance that has it. */
    static ModelError at(Network.Instance instance, ModelError problem) {
        String message = instance.with(String.valueOf(problem.getMessage()));
        return problem instanceof Impasse ? new Impasse(message) : new ModelError(message);
    }

    private List<List<Value>> goOn(Input input, int step, List<Trace.Activity> activities) {
        JointReaction reaction = relations.size() == 1 ? single(input, step) : joint(input, step);
        List<Configuration> next = new ArrayList<>(relations.size());
        for (int i = 0; i < relations.size(); i++) {
            Configuration before = configurations.get(i);
            Reaction own = reaction.reactions().get(i);
            Optional<Refusal> nearest = nearest(i, input, own.cause());
            Configuration after = after(relations.get(i), before, own, nearest);
            activities.add(activity(relations.get(i), before, after, own.cause(), nearest));
            next.add(after);
        }
        configurations = next;
        return messages(reaction.output());
    }

    /** With one automaton, only the transition that is taken is carried out. */
    private JointReaction single(Input input, int step) {
        StepRelation relation = relations.get(0);
        Configuration before = configurations.get(0);
        List<Trace.Taken> enabled =
                choice.isTextOrder()
                        ? relation.firstEnabled(before, input).map(List::of).orElse(List.of())
                        : relation.enabled(before, input);
        Reaction reaction =
                enabled.isEmpty()
                        ? relation.complete(before)
                        : relation.take(
                                pick(enabled, step, t -> Descriptions.of(relation, t)),
                                before,
                                input);
        return new JointReaction(List.of(reaction), reaction.output());
    }

    private JointReaction joint(Input input, int step) {
        Prospect prospect = behaviour.prospect(configurations, input);
        if (prospect.isContradiction()) {
            throw contradiction("for this input");
        }
        if (prospect.reactions().isEmpty()) {
            throw new ModelError(prospect.errors().get(0).message());
        }
        return pick(prospect.reactions(), step, r -> Descriptions.of(relations, r));
    }

    private <T> T pick(List<T> alternatives, int step, Function<T, String> wording) {
        int count = alternatives.size();
        if (count == 1) {
            return alternatives.get(0);
        }
        Question question =
                new Question(instance.path(), step, count, i -> wording.apply(alternatives.get(i)));
        return alternatives.get(choice.pick(question));
    }

    private ModelError contradiction(String when) {
        return new Impasse(
                instance.component().name()
                        + ": its automata contradict each other, no output satisfies all of them "
                        + when);
    }

    /** What comes nearest to a reaction where an automaton had none, if anybody asks. */
    private Optional<Refusal> nearest(int automaton, Input input, Trace.Cause cause) {
        return cause instanceof Trace.Completed
                ? whyNot.flatMap(
                        all -> all.get(automaton).nearest(configurations.get(automaton), input))
                : Optional.empty();
    }

    /** A run keeps the state where a completion allows to leave it. */
    private static Configuration after(
            StepRelation relation,
            Configuration before,
            Reaction reaction,
            Optional<Refusal> nearest) {
        if (reaction.next() == Configuration.ERROR) {
            String why = nearest.map(each -> "; " + each.words()).orElse("");
            throw new ModelError(relation.forbids(before) + why);
        }
        return reaction.next().isState() ? reaction.next() : before;
    }

    private Trace.Activity activity(
            StepRelation relation,
            Configuration before,
            Configuration after,
            Trace.Cause cause,
            Optional<Refusal> nearest) {
        Automaton automaton = relation.automaton();
        return new Trace.Activity(
                instance.path(),
                automaton.name(),
                automaton.states().get(before.state()),
                automaton.states().get(after.state()),
                cause,
                variables(automaton, after),
                nearest);
    }

    private static Map<String, Value> variables(Automaton automaton, Configuration after) {
        if (automaton.variables().isEmpty()) {
            return Map.of();
        }
        Map<String, Value> values = new LinkedHashMap<>();
        for (int i = 0; i < automaton.variables().size(); i++) {
            values.put(automaton.variables().get(i).name(), after.variables().get(i));
        }
        return values;
    }

    private List<List<Value>> messages(Output output) {
        List<List<Value>> messages = new ArrayList<>(outputs.size());
        for (int i = 0; i < outputs.size(); i++) {
            messages.add(messages(outputs.get(i), output.ports().get(i)));
        }
        return messages;
    }

    private List<Value> messages(Port port, Sent sent) {
        if (sent instanceof Sent.Messages messages) {
            return messages.values();
        }
        return choice.message(port, sent instanceof Sent.AnyMessage).stream().toList();
    }

    /**
     * Ends a run that nothing in the model ends: automata that contradict each other leave no way
     * to go on, and what comes from outside may be no message of a port.
     */
    static final class Impasse extends ModelError {
        private static final long serialVersionUID = 1L;

        Impasse(String message) {
            super(message);
        }
    }
}
