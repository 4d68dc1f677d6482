package arcomat.live.browser;

import arcomat.live.Desk;

import org.teavm.jso.JSExport;

/** What scripts find: {@link Desk}, with a name for each question. */
public final class Core {
    private final Desk desk = new Desk();

    @JSExport
    public Core() {}

    @JSExport
    public String check(String[] paths, String[] texts, String[] needed) {
        return desk.check(paths, texts, needed);
    }

    @JSExport
    public String components() {
        return desk.components();
    }

    @JSExport
    public String complete(String path, String text, int offset) {
        return desk.complete(path, text, offset);
    }

    @JSExport
    public String facts(String path, int offset) {
        return desk.facts(path, offset);
    }

    @JSExport
    public String refines(String left, String right, double milliseconds) {
        return desk.refines(left, right, milliseconds);
    }

    @JSExport
    public String verify(double milliseconds) {
        return desk.verify(milliseconds);
    }

    @JSExport
    public String analyze(double milliseconds) {
        return desk.analyze(milliseconds);
    }

    @JSExport
    public String test() {
        return desk.test();
    }

    @JSExport
    public String contradictions(String component, double milliseconds) {
        return desk.contradictions(component, milliseconds);
    }

    @JSExport
    public String run(String component, String[] letters, int[] choices) {
        return desk.run(component, letters, choices);
    }

    @JSExport
    public String record(String component, String[] letters, int[] choices, String suite) {
        return desk.record(component, letters, choices, suite);
    }

    @JSExport
    public String floor(String world, int seed) {
        return desk.floor(world, seed);
    }

    @JSExport
    public String graph(String component, int automaton, String[] closed) {
        return desk.graph(component, automaton, closed);
    }

    @JSExport
    public String picture(String places) {
        return desk.picture(places);
    }
}
