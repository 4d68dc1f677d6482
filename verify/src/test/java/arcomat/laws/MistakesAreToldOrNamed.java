package arcomat.laws;

import arcomat.analysis.coverage.Mutants;
import arcomat.analysis.coverage.Mutants.Mutant;
import arcomat.analysis.coverage.TransitionTests;
import arcomat.analysis.coverage.TransitionTests.Mistake;
import arcomat.analysis.coverage.TransitionTests.Uncovered;
import arcomat.analysis.coverage.TransitionTests.Untold;
import arcomat.analysis.refinement.Verdict;
import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.StreamTest;
import arcomat.semantics.Promise;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * A component with a small mistake that lacks something which the right one does fails a test that
 * {@code tests} writes for the right one, or the suite names the mistake. In slices: suites of
 * events are not made for mistakes.
 */
final class MistakesAreToldOrNamed implements Law {
    /** Of a model with more mistakes, some of each kind. */
    private static final int MOST = 12;

    @Override
    public String name() {
        return "5 mistakes are told or named";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        return List.of(
                ComponentText.types(),
                ComponentText.atomic(draw, "a", "Main", ComponentText.plugs(draw, false), false));
    }

    @Override
    public Outcome check(Models models) {
        Component component = models.component(Pairs.LEFT);
        Promise promise = Questions.promise(component);
        TransitionTests.Result result = TransitionTests.of(promise, "Run", Questions.budget());
        if (!result.uncovered().stream().allMatch(Uncovered::certain)) {
            return Outcome.SKIPPED;
        }
        Map<Mistake, String> named =
                result.untold().stream()
                        .collect(
                                Collectors.toMap(
                                        Untold::mistake, Untold::reason, (one, last) -> last));
        boolean met = false;
        for (Mutant mutant : some(component, named, models.seed())) {
            List<Automaton> automata = mistaken(promise.automata(), mutant);
            boolean loses = Questions.fails(loss(promise, automata));
            if (loses && !isTold(result, with(component, automata))) {
                Mistake mistake = mutant.mistake();
                return Outcome.broken(
                        "no test fails, and the suite does not say so, if %s -> %s %s"
                                .formatted(
                                        mistake.transition().source(),
                                        mistake.transition().target(),
                                        mistake.what()),
                        "tests " + Pairs.LEFT,
                        "test " + Pairs.LEFT);
            }
            met |= loses;
        }
        return met ? Outcome.KEPT : Outcome.SKIPPED;
    }

    private static Verdict loss(Promise promise, List<Automaton> automata) {
        return Questions.refines(promise, promise.withAutomata(automata));
    }

    /** Not those that are named, nor those behind one with which the search for tests has ended. */
    private static List<Mutant> some(Component component, Map<Mistake, String> named, int seed) {
        List<Mutant> silent = new ArrayList<>();
        List<Mutant> all =
                component.automata().stream()
                        .flatMap(each -> new Mutants(component, each).all().stream())
                        .toList();
        for (Mutant mutant : all) {
            String reason = named.get(mutant.mistake());
            if (reason == null) {
                silent.add(mutant);
            } else if (reason.contains("nor any behind it")) {
                break;
            }
        }
        int stride = Math.max(1, silent.size() / MOST);
        List<Mutant> some = new ArrayList<>();
        for (int i = Math.floorMod(seed, stride); i < silent.size(); i += stride) {
            some.add(silent.get(i));
        }
        return some;
    }

    private static List<Automaton> mistaken(List<Automaton> automata, Mutant mutant) {
        List<Automaton> changed = new ArrayList<>(automata);
        int position = automata.indexOf(mutant.mistake().transition().automaton());
        changed.set(position, mutant.automaton());
        return changed;
    }

    private static boolean isTold(TransitionTests.Result result, Component mistaken) {
        return result.tests().stream()
                .map(each -> of(mistaken, each.streams()))
                .anyMatch(
                        each -> StreamTests.run(each).verdict() == StreamTestResult.Verdict.FAILED);
    }

    private static StreamTest of(Component component, StreamTest test) {
        return new StreamTest(
                test.suite(),
                test.name(),
                component,
                test.arguments(),
                test.inputs(),
                test.expected(),
                test.span());
    }

    private static Component with(Component component, List<Automaton> automata) {
        return new Component(
                component.packageName(),
                component.name(),
                component.layer(),
                component.platform(),
                component.deploy(),
                component.profile(),
                component.queueCapacity(),
                component.cycle(),
                component.parameters(),
                component.constants(),
                component.ports(),
                new Component.Atomic(automata),
                component.requirements(),
                component.refines(),
                List.of(),
                component.span());
    }
}
