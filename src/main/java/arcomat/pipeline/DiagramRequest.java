package arcomat.pipeline;

import java.util.List;

/**
 * Pictures that are asked for.
 *
 * @param components qualified names; empty for all components and class diagrams that the paths
 *     name
 * @param out the folder to be written, as a whole
 * @param depth how many levels of parts are shown inside a component
 */
public record DiagramRequest(List<String> components, Format format, String out, int depth) {
    public DiagramRequest {
        components = List.copyOf(components);
    }

    /** Named as on the command line, and as files end. */
    public enum Format {
        svg,
        png,
        dot
    }
}
