package arcomat.generate.view;

import java.util.List;

/**
 * A component with one automaton, as the text of a model.
 *
 * @param imports qualified names
 * @param remarks lines of its comment
 * @param timing empty for the usual one
 * @param initial the initial state with what is sent
 * @param groups the transitions, state by state; states without are left out
 */
public record ControllerView(
        String packageName,
        List<String> imports,
        List<String> remarks,
        String stereotypes,
        String name,
        String refines,
        String timing,
        List<String> ports,
        String completion,
        List<String> states,
        String initial,
        List<List<String>> groups) {}
