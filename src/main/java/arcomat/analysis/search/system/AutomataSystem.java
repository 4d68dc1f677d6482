package arcomat.analysis.search.system;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.letter.LetterClassesPool;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.StepCache;
import arcomat.analysis.search.step.StepCollector;
import arcomat.analysis.search.step.Steps;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.Behaviour;
import arcomat.semantics.automaton.Behaviour.JointError;
import arcomat.semantics.automaton.Behaviour.JointReaction;
import arcomat.semantics.automaton.Behaviour.JointStart;
import arcomat.semantics.automaton.Behaviour.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.DataSorts;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.Attention;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;

/** An atomic component, or the requirements on a component: a conjunction of automata. */
public final class AutomataSystem implements TransitionSystem {
    private final Behaviour behaviour;
    private final List<Port> inputs;
    private final int[] observed;
    private final OutputCubes outputs;
    private final Budget budget;

    private final Numbering<List<Configuration>> configurations = new Numbering<>();
    private final BitSet chaotic = new BitSet();
    private final LetterClassesPool foci;
    private final List<LetterClasses> focus = new ArrayList<>();
    private final List<StepCache> steps = new ArrayList<>();

    /**
     * @param observed names of the output ports that are compared; the others are projected away
     */
    public AutomataSystem(
            Behaviour behaviour, List<String> observed, OutputCubes outputs, Budget budget) {
        this.budget = budget;
        this.behaviour = behaviour;
        this.inputs = behaviour.component().inputs();
        this.foci = new LetterClassesPool(inputs, budget);
        this.outputs = outputs;
        List<String> names = behaviour.component().outputs().stream().map(Port::name).toList();
        this.observed = observed.stream().mapToInt(names::indexOf).toArray();
    }

    @Override
    public Component.Profile profile() {
        return behaviour.component().profile();
    }

    @Override
    public List<Port> inputs() {
        return inputs;
    }

    @Override
    public List<Port> outputs() {
        return behaviour.component().outputs();
    }

    @Override
    public int[] delays() {
        boolean slices = profile() == Component.Profile.TIME_SYNCHRONOUS;
        return IntStream.of(observed)
                .map(i -> i < 0 || !slices ? -1 : outputs().get(i).delay())
                .toArray();
    }

    @Override
    public Steps openings() {
        StepCollector collector = new StepCollector();
        for (JointStart start : behaviour.starts(budget::insist)) {
            collector.add(
                    outputs.number(project(start.output())),
                    number(start.configurations()),
                    List.of(),
                    start.output());
        }
        return collector.steps();
    }

    @Override
    public LetterClasses focus(int configuration) {
        LetterClasses known = focus.get(configuration);
        if (known == null) {
            Attention attention = behaviour.attention(configurations.get(configuration));
            known = foci.of(attention);
            focus.set(configuration, known);
        }
        return known;
    }

    @Override
    public Steps steps(int configuration, long kind, Value[] letter) {
        StepCache known = steps.get(configuration);
        Steps found = known.find(kind);
        return found != null
                ? found
                : known.add(kind, compute(configurations.get(configuration), letter));
    }

    private Steps compute(List<Configuration> before, Value[] letter) {
        StepCollector collector = new StepCollector();
        if (before.contains(Configuration.ERROR)) {
            return collector.steps();
        }
        Prospect prospect = behaviour.prospect(before, Input.of(letter), budget::insist);
        for (JointReaction reaction : prospect.reactions()) {
            budget.insist();
            collector.add(
                    outputs.number(project(reaction.output())),
                    number(reaction.next()),
                    reaction.reactions().stream().map(Reaction::cause).toList(),
                    reaction.output());
        }
        for (JointError error : prospect.errors()) {
            int end = number(List.of(Configuration.ERROR));
            collector.add(OutputCubes.ERROR, end, error.causes(), new Output(List.of()));
        }
        return collector.steps();
    }

    private Output project(Output output) {
        List<Sent> projected = new ArrayList<>(observed.length);
        for (int port : observed) {
            projected.add(port < 0 ? new Sent.Anything() : output.ports().get(port));
        }
        return new Output(projected);
    }

    private int number(List<Configuration> configuration) {
        int number = configurations.number(configuration);
        if (number == steps.size()) {
            chaotic.set(number, configuration.stream().allMatch(c -> c == Configuration.CHAOS));
            focus.add(null);
            steps.add(new StepCache());
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

    /** One configuration per automaton. */
    public List<Configuration> configuration(int number) {
        return configurations.get(number);
    }

    @Override
    public String name(int configuration) {
        return configurations.get(configuration).toString();
    }

    @Override
    public String describe(int configuration) {
        return ConfigurationText.of(behaviour, configurations.get(configuration));
    }

    @Override
    public Set<Trace.Cause> used() {
        Set<Trace.Cause> causes = new LinkedHashSet<>();
        steps.forEach(each -> each.collectUsed(causes));
        return causes;
    }

    @Override
    public DataPlaces data(DataSorts sorts) {
        Map<String, Integer> ports = new HashMap<>();
        for (Port port : behaviour.component().ports()) {
            ports.put(port.name(), sorts.place(port.type()));
        }
        List<int[]> variables =
                behaviour.relations().stream().map(each -> each.tellFlow(sorts, ports)).toList();
        List<Integer> compared =
                IntStream.of(observed)
                        .mapToObj(
                                i ->
                                        i < 0
                                                ? DataPlaces.NOWHERE
                                                : ports.get(outputs().get(i).name()))
                        .toList();
        return new PlacedData(ports, compared) {
            @Override
            public void held(int configuration, Holding holding) {
                held(configurations.get(configuration), variables, holding);
            }
        };
    }

    @Override
    public int size() {
        return configurations.size();
    }
}
