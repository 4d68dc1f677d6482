package arcomat.pipeline.campaign;

import arcomat.campaign.coverage.AutomatonItems;
import arcomat.campaign.coverage.CoverageItems;
import arcomat.generate.AutomatonLines;
import arcomat.model.Automaton;
import arcomat.pipeline.campaign.engine.ItemProbes;
import arcomat.pipeline.campaign.watch.CampaignCode;
import arcomat.sim.load.LineProbe;
import arcomat.source.Span;
import arcomat.world.Kind;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.stream.IntStream;

/**
 * What the runs of a campaign may cover, and where their programs come to it. An automaton that
 * several programs have is covered by whichever comes to it.
 */
record CoveragePlan(CoverageItems items, ItemProbes probes) {
    /**
     * @param code the programs of the campaign
     */
    static CoveragePlan of(CampaignCode code) {
        Map<String, List<AutomatonLines>> programs = new TreeMap<>();
        code.layouts().forEach((program, layout) -> programs.put(program, layout.automata()));
        Map<AutomatonItems, Integer> places = new LinkedHashMap<>();
        programs.values()
                .forEach(
                        all -> all.forEach(each -> places.putIfAbsent(items(each), places.size())));
        CoverageItems items =
                new CoverageItems(List.copyOf(places.keySet()), jars(code.named().values()));
        Map<String, List<LineProbe>> probes = new TreeMap<>();
        programs.forEach(
                (program, all) -> {
                    List<LineProbe> own = new ArrayList<>();
                    for (AutomatonLines each : all) {
                        int place = Objects.requireNonNull(places.get(items(each)));
                        own.addAll(probes(each, place, items));
                    }
                    probes.put(program, own);
                });
        return new CoveragePlan(items, new ItemProbes(items.transitions(), probes));
    }

    private static List<String> jars(Collection<Kind.Program> named) {
        return named.stream()
                .filter(each -> each.form() == Kind.Program.Form.JAR)
                .map(Kind.Program::name)
                .distinct()
                .sorted()
                .toList();
    }

    private static AutomatonItems items(AutomatonLines lines) {
        Automaton automaton = lines.automaton();
        List<AutomatonItems.Transition> transitions = new ArrayList<>();
        for (Automaton.Transition each : automaton.transitions()) {
            boolean coded = lines.lines().transitions().containsKey(transitions.size());
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

    private static int line(Span span) {
        return span.startPosition().line();
    }

    private static String text(Span span) {
        return span.text().replaceAll("\\s+", " ").replaceFirst(" ?;$", "");
    }

    private static List<LineProbe> probes(AutomatonLines lines, int place, CoverageItems items) {
        List<LineProbe> probes = new ArrayList<>();
        new TreeMap<>(lines.lines().transitions())
                .forEach(
                        (index, line) ->
                                probes.add(
                                        new LineProbe(
                                                lines.className(),
                                                line,
                                                items.transition(place, index))));
        new TreeMap<>(lines.lines().initials())
                .forEach(
                        (index, line) ->
                                probes.add(
                                        new LineProbe(
                                                lines.className(),
                                                line,
                                                items.initial(place, index))));
        return probes;
    }
}
