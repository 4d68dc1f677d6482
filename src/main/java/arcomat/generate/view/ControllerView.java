package arcomat.generate.view;

import java.util.List;

/**
 * A component with one automaton, or with some that are written already, as the text of a model.
 *
 * @param imports qualified names
 * @param remarks lines of its comment
 * @param layer empty for the usual one
 * @param instant whether all outputs show what is sent in the same slice
 * @param written texts of automata; the automaton below where there are none
 * @param initial the initial state
 * @param sends what is sent there
 * @param groups the transitions, state by state; states without are left out
 */
public record ControllerView(
        String packageName,
        List<String> imports,
        List<String> remarks,
        String layer,
        String name,
        List<String> refines,
        boolean instant,
        List<DeclarationView> ports,
        List<String> written,
        String completion,
        List<String> states,
        String initial,
        List<String> sends,
        List<List<RuleView>> groups) {

    /** A port; {@code instant} is said of an output that shows what is sent in the same slice. */
    public record DeclarationView(
            boolean input, boolean total, boolean instant, String type, String name) {}

    /**
     * A transition.
     *
     * @param target empty where the state stays
     * @param guard empty where there is none
     * @param items of the input block
     */
    public record RuleView(
            String source, String target, String guard, List<String> items, List<String> sends) {}
}
