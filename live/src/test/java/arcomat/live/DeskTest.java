package arcomat.live;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What the page asks, asked without a page. */
class DeskTest {
    private static final String LAMP =
            """
            component Lamp {
                timing instant;
                port in Boolean button, out Boolean on;

                <<completion = "ignore">> automaton {
                    state dark, bright;
                    initial dark;
                    dark -> bright {button == true} / {on = true};
                    dark {button == true} / {on = false};
                }
            }
            """;

    private static final String[] NOTHING = {};
    private static final int[] NO_CHOICE = {};

    private final Desk desk = new Desk();

    private String check(String text) {
        return desk.check(new String[] {"Lamp.arc"}, new String[] {text}, NOTHING);
    }

    @Test
    void findingsCarryTheirRepairs() {
        assertThat(check(LAMP.replace("initial dark", "initial drk")))
                .contains("\"code\":\"ARC0304\"")
                .contains("\"title\":\"Change to 'dark'\"")
                .contains("\"whole\":false");
    }

    /** As in an editor: states where a transition begins, and the piece for one. */
    @Test
    void offersWhatCouldBeWritten() {
        check(LAMP);
        String text = LAMP.replace("initial dark;", "initial dark;\n        da");
        assertThat(desk.complete("Lamp.arc", text, text.indexOf("        da") + 10))
                .contains("\"label\":\"dark\",\"kind\":\"state\"")
                .contains("\"label\":\"transition\"")
                .doesNotContain("\"label\":\"button\"");
        assertThat(desk.complete("Lamp.arc", "// da", 5)).isEqualTo("{\"names\":[]}");
    }

    @Test
    void knowsWhatANameMeans() {
        check(LAMP);
        assertThat(desk.facts("Lamp.arc", LAMP.indexOf("button == true")))
                .contains("port in Boolean button");
        assertThat(desk.facts("Lamp.arc", 0)).isEqualTo("{}");
    }

    /** Where it has no part in it. */
    @Test
    void anErrorElsewhereForbidsNoPicture() {
        String broken = LAMP.replace("Lamp", "Torch").replace("initial dark", "initial drk");
        String pair = "component Pair { component Lamp lamp; component Torch torch; }";
        String checked =
                desk.check(
                        new String[] {"Lamp.arc", "Torch.arc", "Pair.arc"},
                        new String[] {LAMP, broken, pair},
                        NOTHING);
        assertThat(checked).contains("\"whole\":false");
        assertThat(desk.components())
                .contains("{\"name\":\"Lamp\"")
                .doesNotContain("{\"name\":\"Torch\"")
                .doesNotContain("{\"name\":\"Pair\"");
        assertThat(desk.graph("Lamp", 0, NOTHING)).contains("children").doesNotContain("refused");
        assertThat(desk.graph("Torch", 0, NOTHING)).contains("refused");
        assertThat(desk.graph("Pair", -1, NOTHING)).contains("refused");
        assertThat(desk.run("Lamp", NOTHING, NO_CHOICE)).contains("refused");
    }

    @Test
    void nothingIsAskedOfModelsWithErrors() {
        assertThat(desk.components()).contains("refused");
        check("component {");
        assertThat(desk.verify(1000)).contains("refused");
    }

    @Test
    void aTextThatIsTheSameAgainGivesTheSameAnswer() {
        String first = check(LAMP) + desk.components();
        check(LAMP.replace("initial dark", "initial drk"));
        assertThat(check(LAMP) + desk.components()).isEqualTo(first);
    }

    @Test
    void aRunWaitsWhereNobodyHasChosen() {
        check(LAMP);
        String[] letters = {"button = true"};
        assertThat(desk.run("Lamp", letters, NO_CHOICE)).contains("\"alternatives\":[");
        assertThat(desk.run("Lamp", letters, new int[] {0}))
                .contains("\"outputs\":[\"on = true\"]");
        assertThat(desk.run("Lamp", letters, new int[] {1}))
                .contains("\"outputs\":[\"on = false\"]");
    }

    @Test
    void whatIsNoInputIsRefused() {
        check(LAMP);
        assertThat(desk.run("Lamp", new String[] {"button = perhaps"}, NO_CHOICE))
                .contains("\"refused\":\"'perhaps' is not a value of Boolean\"");
        assertThat(desk.run("Lamp", new String[] {"door = true"}, NO_CHOICE))
                .contains("\"refused\":\"there is no input 'door'\"");
        assertThat(desk.run("Lam", NOTHING, NO_CHOICE)).contains("did you mean 'Lamp'?");
    }

    /** What was recorded is a test that the component passes. */
    @Test
    void aRecordedRunPasses() {
        check(LAMP);
        String suite =
                desk.record("Lamp", new String[] {"button = true"}, new int[] {0}, "LampTest");
        desk.check(new String[] {"Lamp.arc", "LampTest.mt"}, new String[] {LAMP, suite}, NOTHING);
        assertThat(desk.test()).contains("\"answer\":\"passed\"");
    }

    @Test
    void aCounterexampleIsToldStepByStep() {
        String strict = LAMP.replace("Lamp", "Strict").replaceAll(" *dark \\{.*\n", "");
        desk.check(new String[] {"Lamp.arc", "Strict.arc"}, new String[] {LAMP, strict}, NOTHING);
        assertThat(desk.refines("Lamp", "Strict", 10_000))
                .contains("\"answer\":\"fails\"")
                .contains("\"outputs\":[\"on = false\"],\"left\":\"dark\",\"right\":[]");
        assertThat(desk.refines("Strict", "Lamp", 10_000)).contains("\"answer\":\"holds\"");
    }
}
