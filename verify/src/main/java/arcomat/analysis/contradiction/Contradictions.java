package arcomat.analysis.contradiction;

import arcomat.analysis.contradiction.Consistency.Contradiction;
import arcomat.analysis.game.Choices;
import arcomat.analysis.game.CounterStrategy;
import arcomat.analysis.game.CounterStrategy.Turn;
import arcomat.analysis.game.Groups;
import arcomat.analysis.game.Requirement;
import arcomat.analysis.game.Synthesis;
import arcomat.analysis.game.UnsatCores;
import arcomat.analysis.game.controller.Controllers;
import arcomat.analysis.refinement.Explanation;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.product.Counterexample.Allowed;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.system.AutomataSystem;
import arcomat.analysis.search.system.RunErrors;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Whether some requirements on a component contradict each other: whether there is no
 * implementation that satisfies all of them against every input. A safety game on products of
 * subset states, in which the environment picks the input and the system the output; the system
 * loses where a requirement has no successor.
 */
public final class Contradictions {
    /** The last games that were played, and the sets of requirements that lose them. */
    private record Played(UnsatCores cores, List<BitSet> found) {}

    private final Promise promise;
    private final boolean all;
    private final Budget budget;
    private final Choices choices;
    private final List<AutomataSystem> systems = new ArrayList<>();
    private final List<UnsatCores> played = new ArrayList<>();

    private Contradictions(Promise promise, boolean all, Budget budget) {
        this.promise = promise;
        this.all = all;
        this.budget = budget;
        List<Port> outputs = promise.component().outputs();
        List<String> names = outputs.stream().map(Port::name).toList();
        OutputCubes numbers = new OutputCubes();
        this.choices = new Choices(outputs, numbers, budget);
        for (Promise each : promise.each()) {
            systems.add(new AutomataSystem(each.behaviour(), names, numbers, budget));
        }
    }

    /**
     * @param promise the automata that are to be kept together
     * @param all whether to look for all minimal contradicting subsets
     */
    public static Consistency check(Promise promise, boolean all, Budget budget) {
        if (promise.automata().isEmpty()) {
            return new Consistency(
                    Answer.HOLDS,
                    "",
                    List.of(),
                    Optional.empty(),
                    List.of("nothing is required: there is no automaton"),
                    0);
        }
        Contradictions question = new Contradictions(promise, all, budget);
        Consistency found =
                Budget.within(question::search, why -> unknown(why, question.explored()));
        return found.answer() == Answer.HOLDS ? Leniency.noted(promise, found, budget) : found;
    }

    /** One contradiction among the automata of a component; empty where limits end the search. */
    static Optional<Contradiction> first(Promise promise, Budget budget) {
        Contradictions question = new Contradictions(promise, false, budget);
        return Budget.within(question::firstFound, stopped -> Optional.empty());
    }

    private Optional<Contradiction> firstFound() {
        Played end = play();
        return end.found().stream().findFirst().map(core -> tell(end.cores(), core));
    }

    private static Consistency unknown(String reason, long explored) {
        return new Consistency(
                Answer.UNKNOWN, reason, List.of(), Optional.empty(), List.of(), explored);
    }

    private long explored() {
        return played.stream().mapToLong(UnsatCores::explored).sum();
    }

    /**
     * A system that never errs is wanted first. Where there is none, one that errs will do, if it
     * errs only where each requirement may: an error concerns all of them, whatever they write.
     */
    private Played play() {
        UnsatCores unerring = cores(Groups.byOutputs(decided()), false);
        List<BitSet> found = contradicting(unerring);
        boolean kept = found.isEmpty() && unerring.stopped().isEmpty();
        if (kept || !errorsMatter(found)) {
            return new Played(unerring, found);
        }
        UnsatCores erring = cores(Groups.one(systems.size()), true);
        return new Played(erring, contradicting(erring));
    }

    private Consistency search() {
        Played end = play();
        return told(end.cores(), end.found());
    }

    private List<BitSet> contradicting(UnsatCores cores) {
        return all ? cores.every() : cores.first().map(List::of).orElse(List.of());
    }

    /** Whether some contradiction may be none because all of its requirements allow an error. */
    private boolean errorsMatter(List<BitSet> contradicting) {
        return contradicting.isEmpty()
                ? promise.automata().stream().anyMatch(RunErrors::arePossible)
                : contradicting.stream()
                        .anyMatch(each -> members(each).allMatch(RunErrors::arePossible));
    }

    private Stream<Automaton> members(BitSet set) {
        return set.stream().mapToObj(promise.automata()::get);
    }

    /**
     * @param ends whether an error is a way to keep what allows it
     */
    private UnsatCores cores(Groups groups, boolean ends) {
        List<Requirement> requirements = new ArrayList<>();
        for (int i = 0; i < systems.size(); i++) {
            Automaton automaton = promise.automata().get(i);
            requirements.add(new Requirement(systems.get(i), automaton, ends, choices, budget));
        }
        UnsatCores cores = new UnsatCores(requirements, groups, choices, budget);
        played.add(cores);
        return cores;
    }

    /** Per requirement the outputs that it does not leave open for good. */
    private List<BitSet> decided() {
        List<Port> outputs = promise.component().outputs();
        List<BitSet> decided = new ArrayList<>();
        for (Automaton automaton : promise.automata()) {
            Set<String> written = ComponentSemantics.written(automaton);
            BitSet own = new BitSet();
            for (int port = 0; port < outputs.size(); port++) {
                own.set(port, written.contains(outputs.get(port).name()));
            }
            decided.add(own);
        }
        return decided;
    }

    private Consistency told(UnsatCores cores, List<BitSet> found) {
        List<String> notes = new ArrayList<>();
        if (!found.isEmpty()) {
            List<Contradiction> told = found.stream().map(core -> tell(cores, core)).toList();
            if (all && cores.stopped().isPresent()) {
                notes.add("there may be more contradictions: " + cores.stopped().get());
            }
            return new Consistency(Answer.FAILS, "", told, Optional.empty(), notes, explored());
        }
        if (cores.stopped().isPresent()) {
            return unknown(cores.stopped().get(), explored());
        }
        boolean events = promise.component().profile() == Component.Profile.EVENT_DRIVEN;
        Optional<Component> controller = events ? Optional.empty() : controller(cores);
        if (events) {
            notes.add("a controller is not written down where events are handled");
        } else if (controller.isEmpty()) {
            notes.add("a controller has too many states or inputs to be written down");
        }
        return new Consistency(Answer.HOLDS, "", List.of(), controller, notes, explored());
    }

    private Optional<Component> controller(UnsatCores cores) {
        Component required = promise.component();
        return Synthesis.of(cores.won(), budget)
                .map(machine -> Controllers.of(machine, required.span()))
                .map(automaton -> controller(required, automaton, kept()));
    }

    /**
     * What the controller may say it refines: a component that has no more to it than these. What
     * refines a decomposed component does what its parts do, so that it is another component with
     * the same requirements.
     */
    private List<String> kept() {
        Component required = promise.component();
        boolean all = required.automata().size() == promise.automata().size();
        boolean named = required.name().matches("\\w+") && required.parameters().isEmpty();
        if (!all || !named) {
            return List.of();
        }
        if (required.body() instanceof Component.Atomic) {
            return List.of(required.qualifiedName());
        }
        return required.constants().isEmpty()
                ? List.of(required.qualifiedName() + "Requirements")
                : List.of();
    }

    private static Component controller(
            Component required, Automaton automaton, List<String> refines) {
        String name = required.name().replaceAll("\\W", "");
        return new Component(
                required.packageName(),
                name + "Controller",
                required.layer(),
                false,
                false,
                required.profile(),
                required.queueCapacity(),
                required.cycle(),
                List.of(),
                List.of(),
                required.ports(),
                new Component.Atomic(List.of(automaton)),
                List.of(),
                refines,
                List.of(),
                required.span());
    }

    private Contradiction tell(UnsatCores cores, BitSet core) {
        List<Promise> members = core.stream().mapToObj(promise.each()::get).toList();
        CounterStrategy.Won won = CounterStrategy.of(cores.lost(core), budget);
        return new Contradiction(
                members.stream().map(each -> each.automata().get(0)).toList(),
                cores.isMinimal(core),
                won.word(),
                won.decided(),
                won.turns().stream().map(turn -> step(turn, members)).toList());
    }

    /** What requirements ask for where they contradict each other, in words. */
    private static Contradiction.Step step(Turn turn, List<Promise> requirements) {
        List<Sentence> sentences = new ArrayList<>();
        boolean errors = turn.demands().stream().anyMatch(each -> errs(each.allowed()));
        for (Turn.Demand demand : turn.demands()) {
            Promise requirement = requirements.get(demand.requirement());
            boolean errs = errs(demand.allowed());
            boolean only = demand.allowed().stream().allMatch(Allowed::error);
            for (Allowed allowed : demand.allowed()) {
                String words =
                        allowed.error()
                                ? only ? "only an error" : "an error"
                                : Explanation.words(allowed, errors && !errs);
                sentences.add(Explanation.allows(requirement, allowed, words));
            }
        }
        return new Contradiction.Step(turn.input(), turn.answers(), sentences);
    }

    private static boolean errs(List<Allowed> allowed) {
        return allowed.stream().anyMatch(Allowed::error);
    }
}
