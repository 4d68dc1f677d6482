package arcomat.diagram;

import arcomat.diagram.Graph.Edge;
import arcomat.diagram.Graph.End;
import arcomat.diagram.Graph.Form;
import arcomat.diagram.Graph.Line;
import arcomat.diagram.Graph.Node;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A class diagram: enumerations with their constants, classes with their attributes. */
public final class TypesGraph {
    private TypesGraph() {}

    /**
     * @param enumeration or a class
     * @param members constants, or attributes with their types
     * @param above the name of the class that it extends, if that is in the same diagram
     */
    public record TypeBox(
            String name,
            boolean enumeration,
            List<String> members,
            Optional<String> above,
            Span place) {
        public TypeBox {
            members = List.copyOf(members);
        }
    }

    public static Graph of(String name, List<TypeBox> types, Span place) {
        List<Node> nodes = new ArrayList<>();
        List<Edge> edges = new ArrayList<>();
        for (TypeBox type : types) {
            nodes.add(node(type));
            type.above()
                    .ifPresent(
                            above ->
                                    edges.add(
                                            new Edge(
                                                    Mark.of("extends", type.name(), type.place()),
                                                    End.of(type.name()),
                                                    End.of(above),
                                                    List.of())));
        }
        List<Line> title = List.of(Line.bold(name));
        Node frame =
                new Node(Mark.of("frame", "", place), Form.BOX, title, List.of(), nodes, edges, 0);
        return new Graph(name, List.of(frame), Graph.Flow.RIGHT);
    }

    private static Node node(TypeBox type) {
        List<Line> lines = new ArrayList<>();
        if (type.enumeration()) {
            lines.add(Line.small("«enum»"));
        }
        lines.add(Line.bold(type.name()));
        type.members().forEach(member -> lines.add(Line.plain(member)));
        String kind = type.enumeration() ? "enum" : "class";
        return Node.leaf(Mark.of(kind, type.name(), type.place()), Form.CARD, lines);
    }
}
