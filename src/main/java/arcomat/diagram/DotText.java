package arcomat.diagram;

import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.End;
import arcomat.diagram.Graph.Line;
import arcomat.diagram.Graph.Node;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** Writes a graph in the language of Graphviz, whose programs find places of their own. */
public final class DotText {
    private final StringBuilder text = new StringBuilder();
    private final Set<String> open = new HashSet<>();
    private final Set<String> delayed = new HashSet<>();

    /** Tells nodes of one outermost node from those of another. */
    private String prefix = "";

    private DotText() {}

    public static String render(Graph graph) {
        DotText dot = new DotText();
        dot.text.append("digraph " + quoted(graph.title()) + " {\n");
        dot.text.append("  rankdir=LR;\n");
        dot.text.append("  node [shape=box, fontname=Helvetica, fontsize=12];\n");
        dot.text.append("  edge [fontname=Helvetica, fontsize=10];\n");
        for (Node root : graph.roots()) {
            dot.prefix = graph.roots().size() > 1 ? root.name() + " " : "";
            dot.node(root, "  ");
        }
        return dot.text.append("}\n").toString();
    }

    private void node(Node node, String indent) {
        node.ports().stream()
                .filter(port -> port.mark().styles().contains("delayed"))
                .forEach(port -> delayed.add(port.mark().name()));
        if (node.children().isEmpty()) {
            String shape =
                    switch (node.form()) {
                        case BOX -> "";
                        case ROUND -> ", style=rounded";
                        case DOT, JUNCTION -> ", shape=point";
                        case CARD -> "";
                    };
            text.append(indent + key(node.name()) + " [label=" + label(node.lines()))
                    .append(shape + "];\n");
            return;
        }
        text.append(indent + "subgraph " + quoted("cluster " + prefix + node.name()) + " {\n");
        String deeper = indent + "  ";
        text.append(deeper + "label=" + label(node.lines()) + ";\n");
        for (Graph.Port port : node.ports()) {
            text.append(deeper + key("port " + port.mark().name()) + " [label=")
                    .append(quoted(sign(port.mark().name()) + port.label()) + ", shape=plain];\n");
        }
        node.children().forEach(child -> node(child, deeper));
        node.children().stream()
                .filter(child -> !child.children().isEmpty())
                .forEach(child -> open.add(child.name()));
        edges(node.edges(), deeper);
        text.append(indent + "}\n");
    }

    private void edges(List<Edge> edges, String indent) {
        for (Edge edge : edges) {
            text.append(indent + key(end(edge.source())) + " -> " + key(end(edge.target())));
            String ports = ends(edge);
            String label = edge.captions().isEmpty() ? ports : ", label=" + label(lines(edge));
            text.append(label.isEmpty() ? ";\n" : " [" + label.substring(2) + "];\n");
        }
    }

    /** Closed boxes have no places for ports; their names stand at the ends of the edge. */
    private String ends(Edge edge) {
        return atEnd("taillabel", edge.source()) + atEnd("headlabel", edge.target());
    }

    private String atEnd(String attribute, End end) {
        if (end.port().isEmpty() || end.node().isEmpty() || open.contains(end.node().get())) {
            return "";
        }
        String path = end.port().get();
        String name = path.substring(path.lastIndexOf('.') + 1);
        return ", " + attribute + "=" + quoted(sign(path) + name);
    }

    private String end(End end) {
        Optional<String> port =
                end.node().isEmpty() || open.contains(end.node().get())
                        ? end.port()
                        : Optional.empty();
        return port.map(name -> "port " + name).orElseGet(() -> end.node().orElse(""));
    }

    /** As in other pictures, what sends one slice later is filled. */
    private String sign(String port) {
        return delayed.contains(port) ? "\u25a0 " : "";
    }

    private static List<Line> lines(Edge edge) {
        return edge.captions().stream().flatMap(caption -> caption.lines().stream()).toList();
    }

    private String key(String name) {
        return quoted(prefix + name);
    }

    private static String label(List<Line> lines) {
        return lines.stream()
                .map(line -> escaped(line.text()))
                .collect(Collectors.joining("\\n", "\"", "\""));
    }

    private static String quoted(String raw) {
        return "\"" + escaped(raw) + "\"";
    }

    private static String escaped(String raw) {
        return raw.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n");
    }
}
