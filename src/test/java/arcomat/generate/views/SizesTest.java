package arcomat.generate.views;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.SampleComponents;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.generate.view.AtomicView.StateView;
import arcomat.generate.view.AtomicView.TransitionView;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.generate.view.HeadView.FieldView;
import arcomat.semantics.ComponentBuilder;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;

/** Virtual machines want small methods: how large they are, and where they are cut. */
class SizesTest {
    private static TransitionView transition(String condition, int messages, int assignments) {
        AssignmentView some = new AssignmentView("field", "this.other + 1");
        return new TransitionView(
                0,
                "",
                condition,
                List.of(new FieldView("int", "local", "a", "")),
                Collections.nCopies(messages, some),
                Collections.nCopies(assignments, some),
                "t",
                "");
    }

    @Test
    void namesWithTheirQualifiersAndNumbersAreWords() {
        assertThat(MethodSize.words("LightCode.RED == light && n<=12")).isEqualTo(4);
        assertThat(MethodSize.words("")).isZero();
    }

    @Test
    void eachWordOfATransitionCounts() {
        int bare = MethodSize.of(transition("", 0, 0));
        assertThat(MethodSize.of(transition("a && b", 0, 0)) - bare).isEqualTo(2 * 8);
        assertThat(MethodSize.of(transition("", 2, 0)) - bare).isEqualTo(2 * 3 * 8);
        assertThat(MethodSize.of(transition("", 0, 2)) - bare).isEqualTo(2 * 3 * 8);
    }

    @Test
    void transitionsAreSplitBeforeAMethodGetsTooLarge() {
        TransitionView large = transition("a ".repeat(240), 0, 0); // some 1,950 bytes
        List<TransitionView> many = Collections.nCopies(7, large);
        assertThat(MethodSize.fits(many)).isFalse();
        assertThat(MethodSize.split(many)).extracting(List::size).containsExactly(3, 3, 1);
        assertThat(MethodSize.split(many)).allMatch(MethodSize::fits);
        TransitionView huge = transition("a ".repeat(2400), 0, 0);
        assertThat(MethodSize.split(List.of(huge, huge))).hasSize(2);
    }

    /** The classes of a whole with many parts, for a target that has no arrays of them. */
    private static Map<String, String> classes(int parts, Choosing choosing) {
        Target jvm = Target.shipped("jvm").orElseThrow();
        Map<String, String> files = new HashMap<>(jvm.files());
        files.computeIfPresent(
                "target.properties", (name, text) -> text.replaceAll("(?m)^element .*", ""));
        ComponentBuilder whole = ComponentBuilder.component("Whole");
        for (int i = 0; i < parts; i++) {
            whole.part("p" + i, SampleComponents.undecided());
        }
        Generation generation =
                Generator.generate(
                        Request.library(whole.build(), choosing), new Target("own", files));
        assertThat(generation.findings()).isEmpty();
        Map<String, String> classes = new TreeMap<>();
        for (GeneratedFile file : generation.files()) {
            String name = file.path().replaceAll(".*/|\\.java", "");
            if (name.startsWith("Whole")) {
                classes.put(name, file.text());
            }
        }
        return classes;
    }

    private static long parts(String text) {
        return Pattern.compile(" = new Undecided\\(").matcher(text).results().count();
    }

    @Test
    void manyPartsAreHeldByClassesOfTheirOwn() {
        assertThat(classes(10, Choosing.FIRST)).containsOnlyKeys("Whole");
        Map<String, String> classes = classes(100, Choosing.FIRST);
        assertThat(classes).containsOnlyKeys("Whole", "WholeSection0", "WholeSection1");
        assertThat(parts(classes.get("Whole"))).isZero();
        assertThat(parts(classes.get("WholeSection0")) + parts(classes.get("WholeSection1")))
                .isEqualTo(100);
        assertThat(classes.get("Whole")).contains("section0.step();", "section1.step();");
    }

    @Test
    void sectionsThatDrawAreGivenTheGenerator() {
        assertThat(classes(100, Choosing.RANDOM).get("Whole"))
                .contains("new WholeSection0(this, choice)");
        assertThat(classes(100, Choosing.FIRST).get("Whole")).contains("new WholeSection0(this)");
    }

    private static StateView state(TransitionView... transitions) {
        return new StateView("", "S", List.of(transitions), false, false, false, List.of(), "");
    }

    @Test
    void statesShareAMethodAsLongAsItStaysSmall() {
        StateView small = state(transition("a ".repeat(240), 0, 0));
        assertThat(MethodSize.statesPerMethod(Collections.nCopies(3, small))).isZero();
        assertThat(MethodSize.statesPerMethod(Collections.nCopies(4, small))).isEqualTo(2);
        assertThat(MethodSize.statesPerMethod(Collections.nCopies(9, small))).isEqualTo(3);
        StateView huge = state(transition("a ".repeat(2400), 0, 0));
        assertThat(MethodSize.statesPerMethod(List.of(huge, huge))).isEqualTo(1);
        assertThat(MethodSize.statesPerMethod(List.of(huge))).isZero();
    }

    @Tag("slow")
    @Test
    void manySectionsAreHeldBySections() {
        Map<String, String> classes = classes(7000, Choosing.FIRST);
        assertThat(classes.values().stream().mapToLong(SizesTest::parts).sum()).isEqualTo(7000);
        assertThat(classes).allSatisfy((name, text) -> assertThat(parts(text)).isLessThan(101));
        assertThat(classes.get("Whole"))
                .contains("new WholeLevel1section0(", "new WholeLevel1section1(")
                .doesNotContain("new WholeSection0(");
        assertThat(classes.get("WholeLevel1section0"))
                .contains("new WholeSection0(", "new WholeSection99(")
                .doesNotContain("new WholeSection100(");
    }
}
