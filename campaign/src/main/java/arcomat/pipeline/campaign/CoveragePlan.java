package arcomat.pipeline.campaign;

import arcomat.campaign.coverage.AutomatonItems;
import arcomat.campaign.coverage.CoverageItems;
import arcomat.campaign.coverage.ItemNumbers;
import arcomat.campaign.coverage.PartItems;
import arcomat.generate.AutomatonLines;
import arcomat.generate.CodeLayout;
import arcomat.model.Automaton;
import arcomat.pipeline.campaign.engine.ItemProbes;
import arcomat.pipeline.campaign.engine.ProgramItems;
import arcomat.pipeline.campaign.watch.CampaignCode;
import arcomat.sim.load.NotedLines;
import arcomat.source.Span;
import arcomat.world.Kind;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;

/**
 * What the runs of a campaign may cover, and where their programs come to it. An automaton that
 * several parts have is covered by whichever comes to it, and by each for itself.
 */
final class CoveragePlan {
    private final Map<String, CodeLayout> layouts;
    private final Map<AutomatonItems, Integer> places = new LinkedHashMap<>();
    private final Map<PartItems, List<Found>> parts = new LinkedHashMap<>();

    private CoveragePlan(Map<String, CodeLayout> layouts) {
        this.layouts = new TreeMap<>(layouts);
    }

    /** Where a program has a part; a robot may have several programs that have it. */
    private record Found(String program, String fields) {}

    /** What came of it. */
    record Result(CoverageItems items, ItemProbes probes) {}

    /**
     * @param code the programs of the campaign
     */
    static Result of(CampaignCode code) {
        CoveragePlan plan = new CoveragePlan(code.layouts());
        plan.findAutomata();
        code.robots().forEach(plan::findParts);
        CoverageItems items =
                new CoverageItems(
                        List.copyOf(plan.places.keySet()),
                        List.copyOf(plan.parts.keySet()),
                        jars(code.named().values()));
        return new Result(items, plan.probes(items));
    }

    private static List<String> jars(Collection<Kind.Program> named) {
        return named.stream()
                .filter(each -> each.form() == Kind.Program.Form.JAR)
                .map(Kind.Program::name)
                .distinct()
                .sorted()
                .toList();
    }

    private void findAutomata() {
        for (CodeLayout layout : layouts.values()) {
            layout.automata().forEach(each -> places.putIfAbsent(items(each), places.size()));
        }
    }

    private void findParts(String robot, Set<String> programs) {
        for (String program : programs) {
            CodeLayout layout = layouts.get(program);
            if (layout == null) {
                continue;
            }
            for (PartPlace place : PartPlace.all(layout)) {
                for (AutomatonLines each : layout.automata()) {
                    if (each.component().qualifiedName().equals(place.component())) {
                        PartItems part = new PartItems(robot, place.path(), place(each));
                        parts.computeIfAbsent(part, p -> new ArrayList<>())
                                .add(new Found(program, place.fields()));
                    }
                }
            }
        }
    }

    private int place(AutomatonLines lines) {
        return Objects.requireNonNull(places.get(items(lines)));
    }

    private ItemProbes probes(CoverageItems items) {
        Map<String, List<ProgramItems.OfPart>> counted = counted(items);
        Map<String, ProgramItems> programs = new TreeMap<>();
        layouts.forEach(
                (program, layout) ->
                        programs.put(
                                program,
                                new ProgramItems(
                                        PartPlace.whole(layout),
                                        layout.automata().stream()
                                                .map(each -> ofClass(each, items))
                                                .toList(),
                                        counted.getOrDefault(program, List.of()))));
        return new ItemProbes(items.transitions(), programs);
    }

    /** The parts that are counted by themselves, by program. */
    private Map<String, List<ProgramItems.OfPart>> counted(CoverageItems items) {
        Map<String, List<ProgramItems.OfPart>> counted = new TreeMap<>();
        List<ItemNumbers> numbers = items.ofParts();
        for (int i = 0; i < numbers.size(); i++) {
            PartItems part = items.parts().get(i);
            int first = numbers.get(i).transition();
            if (items.isShared(part)) {
                for (Found each : Objects.requireNonNull(parts.get(part))) {
                    counted.computeIfAbsent(each.program(), p -> new ArrayList<>())
                            .add(new ProgramItems.OfPart(part.robot(), first, each.fields()));
                }
            }
        }
        return counted;
    }

    private ProgramItems.OfClass ofClass(AutomatonLines lines, CoverageItems items) {
        ItemNumbers numbers = items.ofAutomaton(place(lines));
        List<Integer> counted = counted(lines);
        List<Integer> noted = new ArrayList<>();
        for (int i : counted) {
            noted.add(lines.lines().transitions().getOrDefault(i, 0));
        }
        for (int i = 0; i < lines.automaton().initials().size(); i++) {
            noted.add(lines.lines().initials().getOrDefault(i, 0));
        }
        return new ProgramItems.OfClass(
                numbers.transition(),
                numbers.initial(),
                counted.size(),
                new NotedLines(lines.className(), noted));
    }

    private static AutomatonItems items(AutomatonLines lines) {
        Automaton automaton = lines.automaton();
        List<AutomatonItems.Transition> transitions = new ArrayList<>();
        for (int i : counted(lines)) {
            Automaton.Transition each = automaton.transitions().get(i);
            boolean coded = lines.lines().transitions().containsKey(i);
            transitions.add(
                    new AutomatonItems.Transition(
                            line(each.span()), text(each.span()), each.target(), coded));
        }
        List<AutomatonItems.State> states =
                IntStream.range(0, automaton.states().size())
                        .mapToObj(
                                i ->
                                        new AutomatonItems.State(
                                                line(automaton.places().get(i)),
                                                automaton.states().get(i)))
                        .toList();
        return new AutomatonItems(
                lines.component().qualifiedName(),
                lines.component().span().file().path(),
                transitions,
                states,
                automaton.initials().stream().map(Automaton.Initial::state).toList());
    }

    /** Transitions by their positions; the first way through statements stands for all of them. */
    private static List<Integer> counted(AutomatonLines lines) {
        List<Automaton.Transition> all = lines.automaton().transitions();
        return IntStream.range(0, all.size())
                .filter(i -> i == 0 || !all.get(i).isSameStatements(all.get(i - 1)))
                .boxed()
                .toList();
    }

    private static int line(Span span) {
        return span.startPosition().line();
    }

    private static String text(Span span) {
        return span.text().replaceAll("\\s+", " ").replaceFirst(" ?;$", "");
    }
}
