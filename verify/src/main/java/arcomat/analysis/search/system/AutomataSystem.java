package arcomat.analysis.search.system;

import arcomat.analysis.reachability.Preconditions;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.smt.DataStep;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointError;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.DataSorts;
import arcomat.semantics.expression.Output;
import arcomat.semantics.value.InputAbstraction;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** An atomic component, or the requirements on a component: a conjunction of automata. */
public final class AutomataSystem extends ModelSystem<List<Configuration>> {
    private final ComponentSemantics behaviour;
    private final Budget budget;
    private final BitSet chaotic = new BitSet();

    /** Per automaton, as far as they have been asked for, one per transition. */
    private final List<List<Preconditions>> preconditions = new ArrayList<>();

    /**
     * @param observed names of the output ports that are compared
     */
    public AutomataSystem(
            ComponentSemantics behaviour, List<String> observed, OutputCubes cubes, Budget budget) {
        super(
                behaviour.component(),
                behaviour.component().inputs(),
                behaviour.component().outputs(),
                observed,
                cubes,
                budget);
        this.budget = budget;
        this.behaviour = behaviour;
    }

    @Override
    int delay(int output) {
        return outputs().get(output).delay();
    }

    @Override
    public Steps openings() {
        Steps.Collector collector = new Steps.Collector();
        for (JointStart start : behaviour.starts(budget::insist)) {
            Output output = start.output();
            int next = configuration(start.configurations());
            collector.add(observed(output.ports()), next, List.of(), output);
        }
        return collector.steps();
    }

    @Override
    InputAbstraction abstraction(int configuration) {
        return behaviour.abstraction(get(configuration));
    }

    @Override
    Steps compute(List<Configuration> before, long kind, Value[] letter) {
        Steps.Collector collector = new Steps.Collector();
        if (before.contains(Configuration.ERROR)) {
            return collector.steps();
        }
        Prospect prospect = behaviour.prospect(before, Input.of(letter), budget::insist);
        for (JointReaction reaction : prospect.reactions()) {
            budget.insist();
            collector.add(
                    observed(reaction.output().ports()),
                    configuration(reaction.next()),
                    reaction.reactions().stream().map(Reaction::cause).toList(),
                    reaction.output());
        }
        for (JointError error : prospect.errors()) {
            int end = configuration(List.of(Configuration.ERROR));
            collector.add(OutputCubes.ERROR, end, error.causes(), new Output(List.of()));
        }
        return collector.steps();
    }

    private int configuration(List<Configuration> configuration) {
        int met = size();
        int number = number(configuration);
        if (number == met) {
            chaotic.set(number, configuration.stream().allMatch(c -> c == Configuration.CHAOS));
        }
        return number;
    }

    @Override
    public boolean isChaos(int configuration) {
        return chaotic.get(configuration);
    }

    @Override
    public boolean postpones() {
        return false;
    }

    @Override
    public boolean mayErr() {
        return behaviour.relations().stream()
                .anyMatch(relation -> RunErrors.arePossible(relation.automaton()));
    }

    @Override
    public Optional<List<DataStep>> dataSteps(int configuration) {
        List<DataStep> steps = new ArrayList<>();
        List<Configuration> each = get(configuration);
        for (int i = 0; i < behaviour.relations().size() && each.size() > i; i++) {
            steps.addAll(DataStep.outOf(each.get(i), behaviour.relations().get(i), ready(i)));
        }
        return Optional.of(steps);
    }

    private List<Preconditions> ready(int automaton) {
        while (preconditions.size() <= automaton) {
            preconditions.add(
                    Preconditions.of(
                            profile(),
                            behaviour.relations().get(preconditions.size()).automaton()));
        }
        return preconditions.get(automaton);
    }

    /** One per automaton. */
    public List<Configuration> configurations(int number) {
        return get(number);
    }

    @Override
    public String name(int configuration) {
        return get(configuration).toString();
    }

    @Override
    public String describe(int configuration) {
        return ConfigurationText.of(behaviour, get(configuration));
    }

    @Override
    public DataPlaces data(DataSorts sorts) {
        Map<String, Integer> ports = new HashMap<>();
        for (Port port : behaviour.component().ports()) {
            ports.put(port.name(), sorts.place(port.type()));
        }
        List<int[]> variables =
                behaviour.relations().stream().map(each -> each.tellFlow(sorts, ports)).toList();
        return new DataPlaces(
                ports,
                observed(i -> ports.get(outputs().get(i).name())),
                (configuration, holding) -> holding.values(get(configuration), variables));
    }
}
