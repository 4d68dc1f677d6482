package arcomat.diagram;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.diagram.Picture.Box;
import arcomat.lower.Lowering;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.models.ModelFiles;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** In a picture nothing lies upon anything else, and it is always the same. */
class LayoutTest {
    private static final int ALL = 100;

    private static String svg(Graph graph) {
        return SvgText.render(LayeredLayout.of(graph), Theme.ADAPTIVE, place -> Optional.empty());
    }

    private static List<Graph> graphs(Model model) {
        List<Graph> graphs = new ArrayList<>();
        for (Component component : model.components()) {
            graphs.add(ComponentGraph.of(component, ALL));
            for (Automaton automaton : component.automata()) {
                graphs.add(AutomatonGraph.of(component, automaton));
            }
        }
        return graphs;
    }

    private static Model coffee() {
        return Lowering.lower(
                Workspace.of(
                        ModelFiles.of(Path.of("models/coffee")).stream()
                                .map(file -> Parser.parse(file).unit().orElseThrow())
                                .toList(),
                        Set.of(),
                        HouseLanguages.reader()));
    }

    @Tag("slow")
    @Test
    void coffeeService() {
        List<Graph> graphs = graphs(coffee());
        assertThat(graphs).hasSizeGreaterThan(30);
        for (Graph graph : graphs) {
            String svg = svg(graph);
            assertThat(Overlaps.in(svg)).as(graph.title()).isEmpty();
            assertThat(svg(graph)).isEqualTo(svg);
        }
    }

    /** Where no wire crosses another one for that. */
    @Property(tries = 30)
    void partsStandInTheOrderOfTheText(@ForAll @IntRange(min = 2, max = 12) int count) {
        StringBuilder text = new StringBuilder("component Fan {\nport in Boolean i;\n");
        text.append("component Lamp { port in Boolean i; }\n");
        for (int part = 0; part < count; part++) {
            // By their names they stood elsewhere.
            String name = "p" + part * 7 % count + "x" + part;
            text.append("component Lamp %s;\n".formatted(name));
            text.append("connect i -> %s.i;\n".formatted(name));
        }
        Component fan = model(text.append("}\n").toString()).component("Fan").orElseThrow();
        Graph graph = ComponentGraph.of(fan, ALL);
        Picture picture = LayeredLayout.of(graph);
        List<Box> parts =
                graph.roots().get(0).children().stream()
                        .map(part -> box(picture, part.mark()))
                        .toList();
        assertThat(parts).hasSize(count);
        for (int i = 1; i < parts.size(); i++) {
            assertThat(parts.get(i).y()).isGreaterThan(parts.get(i - 1).y());
        }
    }

    /** As lines are read, however large each of them is. */
    @Property(tries = 50)
    void typesStandInTheOrderOfTheText(@ForAll List<@IntRange(min = 1, max = 9) Integer> sizes) {
        Span place = new SourceFile("Types.cd", "").span(0, 0);
        List<TypesGraph.TypeBox> types = new ArrayList<>();
        for (int constants : sizes) {
            types.add(
                    new TypesGraph.TypeBox(
                            "T" + types.size(),
                            true,
                            Collections.nCopies(constants, "constant"),
                            Optional.empty(),
                            place));
        }
        Graph graph = TypesGraph.of("Types", types, place);
        Picture picture = LayeredLayout.of(graph);
        List<Box> boxes =
                graph.roots().get(0).children().stream()
                        .map(type -> box(picture, type.mark()))
                        .toList();
        for (int i = 1; i < boxes.size(); i++) {
            Box before = boxes.get(i - 1);
            Box box = boxes.get(i);
            assertThat(box.x() > before.x() || box.y() > before.y()).isTrue();
            assertThat(box.y()).isGreaterThanOrEqualTo(before.y());
        }
    }

    private static Box box(Picture picture, Mark mark) {
        return picture.elements().stream()
                .filter(each -> each.mark().equals(mark))
                .flatMap(each -> each.shapes().stream())
                .filter(Picture.Rectangle.class::isInstance)
                .map(each -> ((Picture.Rectangle) each).box())
                .findFirst()
                .orElseThrow();
    }

    /** Ten states and 45 transitions: all of it on a small screen, in letters that can be read. */
    @Test
    void aLargeAutomatonIsReadableOnASmallScreen() {
        Graph graph =
                graphs(coffee()).stream()
                        .filter(each -> each.title().equals("coffee.floor.Drive"))
                        .skip(1) // the component itself
                        .findFirst()
                        .orElseThrow();
        Picture picture = LayeredLayout.of(graph);
        double scale = Math.min(1440 / picture.width(), 900 / picture.height());
        assertThat(11 * scale).as("pixels of its smallest letters").isGreaterThan(9);
    }

    /** What is cut is compared in full: they only look the same. */
    @Test
    void transitionsThatOnlyLookTheSameShareNoLabel() {
        String sum = "n * 1000001 + n * 1000003 + n * 1000007 + n * 1000009 + n * 1000021 + n * 3";
        String model =
                """
                component Counter {
                    port in Integer n;
                    automaton {
                        state a, b, c;
                        initial a;
                        a -> c [%s > 1];
                        b -> c [%s > %d];
                    }
                }
                """;
        assertThat(svg(automaton(model.formatted(sum, sum, 1))))
                .contains("data-transition=\"0 1\"");
        assertThat(svg(automaton(model.formatted(sum, sum, 2))))
                .contains("data-transition=\"0\"", "data-transition=\"1\"");
    }

    private static Graph automaton(String text) {
        return graphs(model(text)).get(1);
    }

    private static Model model(String text) {
        SourceFile file = new SourceFile("Counter.arc", text);
        Workspace workspace =
                Workspace.of(
                        List.of(Parser.parse(file).unit().orElseThrow()),
                        Set.of(),
                        HouseLanguages.reader());
        return Lowering.lower(workspace);
    }

    @net.jqwik.api.Tag("slow")
    @Property(tries = 150)
    void anyComposition(@ForAll @IntRange(min = 0) int seed) {
        Graph graph = ComponentGraph.of(RandomModels.composite(seed), ALL);
        assertThat(Overlaps.in(svg(graph))).isEmpty();
    }

    @net.jqwik.api.Tag("slow")
    @Property(tries = 150)
    void anyAutomaton(@ForAll @IntRange(min = 0) int seed) {
        Component component = RandomModels.automaton(seed);
        Graph graph = AutomatonGraph.of(component, component.automata().get(0));
        assertThat(Overlaps.in(svg(graph))).isEmpty();
    }

    /** An arrow may cross the box of states that it has nothing to do with; nothing else may. */
    @net.jqwik.api.Tag("slow")
    @Property(tries = 100)
    void anyAutomatonInBoxes(@ForAll @IntRange(min = 0) int seed) {
        Component component = RandomModels.automaton(seed);
        Automaton plain = component.automata().get(0);
        List<List<String>> within = new ArrayList<>();
        for (int i = 0; i < plain.states().size(); i++) {
            within.add(List.of("p", "q", "r").subList(0, (seed % 97 + i * i) % 3));
        }
        Graph graph = AutomatonGraph.of(component, plain.within(within));
        assertThat(Overlaps.in(svg(graph)))
                .filteredOn(each -> !each.contains(" runs through group "))
                .isEmpty();
        assertThat(svg(graph)).isEqualTo(svg(graph));
    }

    /** The run, and any automaton on both sides with any marks. */
    @net.jqwik.api.Tag("slow")
    @Property(tries = 50)
    void anyFailure(@ForAll @IntRange(min = 0) int seed) {
        Component component = RandomModels.automaton(seed);
        Highlights.Highlight step = new Highlights.Highlight(Highlights.Kind.ACTIVE, "step 1", "");
        Map<Integer, List<Highlights.Highlight>> marks = Map.of(0, List.of(step));
        Automaton automaton = component.automata().get(0);
        Graph side = AutomatonGraph.of("side", automaton, new Highlights(marks, Map.of()));
        List<FailureGraph.Step> steps = new ArrayList<>();
        for (int i = 0; i <= seed % 9; i++) {
            steps.add(new FailureGraph.Step(List.of("a = " + i, "/ x = 1"), "here", List.of()));
        }
        Graph failure = FailureGraph.of("A and B", steps, Optional.of(side), Optional.of(side));
        assertThat(Overlaps.in(svg(failure))).isEmpty();
    }

    /**
     * Computing time: the machine may have other work. Then Java's compiler comes late, too, so the
     * first rounds may take longer.
     */
    @Tag("slow")
    @Test
    void aHundredComponentsInThreeSeconds() {
        List<Graph> graphs = new ArrayList<>();
        for (int i = 0; i < 50; i++) {
            Component component = RandomModels.automaton(i);
            graphs.add(AutomatonGraph.of(component, component.automata().get(0)));
            graphs.add(ComponentGraph.of(RandomModels.composite(i), ALL));
        }
        Duration three = Duration.ofSeconds(3);
        Duration best = computingTime(graphs);
        for (int round = 1; round < 4 && best.compareTo(three) >= 0; round++) {
            best = computingTime(graphs);
        }
        assertThat(best).isLessThan(three);
    }

    private static Duration computingTime(List<Graph> graphs) {
        ThreadMXBean clock = ManagementFactory.getThreadMXBean();
        long start = clock.getCurrentThreadCpuTime();
        graphs.forEach(LayoutTest::svg);
        return Duration.ofNanos(clock.getCurrentThreadCpuTime() - start);
    }
}
