package montiarc7;

import montiarc7.grammar.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ListExpressionContext;
import montiarc7.grammar.MontiArc7Parser.MapEntryContext;
import montiarc7.grammar.MontiArc7Parser.MapPartContext;
import montiarc7.grammar.MontiArc7Parser.MappingContext;
import montiarc7.grammar.MontiArc7Parser.MemberExpressionContext;
import montiarc7.grammar.MontiArc7Parser.NameExpressionContext;
import montiarc7.source.Lack;
import montiarc7.source.Lacks;
import montiarc7.statement.ExpressionWriter;
import montiarc7.statement.Guards;
import montiarc7.statement.Scope;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * A map component. Of the entries that are true together the first one counts: two of them that
 * demand different things cannot both be kept, and a finding says where that may be.
 */
final class MapWriter {
    private final String name;
    private final MapSide concrete;
    private final MapSide reference;
    private final Lacks lacks;

    MapWriter(String name, MapSide concrete, MapSide reference, Lacks lacks) {
        this.name = name;
        this.concrete = concrete;
        this.reference = reference;
        this.lacks = lacks;
    }

    String write(MappingContext mapping) {
        StringBuilder text = new StringBuilder();
        text.append("/** How the ports of ").append(concrete.name()).append(" stand for those of ");
        text.append(reference.name())
                .append(". */\n<<map>> component ")
                .append(name)
                .append(" {\n");
        for (MapPartContext part : mapping.mapPart()) {
            if (part.kind.getText().equals("inputMap")) {
                text.append(half("Inputs", part, concrete.inputs(), reference.inputs()));
            } else if (part.kind.getText().equals("outputMap")) {
                text.append(half("Outputs", part, concrete.outputs(), reference.outputs()));
            }
        }
        return text.append("}\n").toString();
    }

    private String half(
            String half, MapPartContext part, Map<String, String> from, Map<String, String> to) {
        ExpressionWriter left = new Writer(from.keySet(), concrete, reference);
        ExpressionWriter right = new Writer(to.keySet(), reference, concrete);
        Guards guards = new Guards(left);
        StringBuilder text = new StringBuilder("component " + half + " {\ntiming instant;\n");
        List<String> ports = new ArrayList<>();
        from.forEach((port, type) -> ports.add("in " + type + " " + left.port(port)));
        to.forEach((port, type) -> ports.add("out " + type + " " + right.port(port)));
        text.append(ports.stream().collect(Collectors.joining(",\n", "port ", ";\n")));
        text.append("<<completion = \"ignore\">> automaton {\nstate mapping;\ninitial mapping;\n");
        List<MapEntryContext> before = new ArrayList<>();
        for (MapEntryContext each : part.mapEntry()) {
            text.append(entry(each, before, left, right, guards));
            before.add(each);
        }
        return text.append("}\n}\n").toString();
    }

    private String entry(
            MapEntryContext entry,
            List<MapEntryContext> before,
            ExpressionWriter left,
            ExpressionWriter right,
            Guards guards) {
        ExpressionContext own = entry.expression(0);
        List<String> parts = new ArrayList<>(List.of("(" + left.write(own) + ")"));
        boolean toldOverlap = false;
        for (MapEntryContext each : before) {
            ExpressionContext earlier = each.expression(0);
            if (guards.exclude(earlier, own)) {
                continue;
            }
            parts.add(guards.notTrue(earlier, Guards.parts(own), guards.presentIn(own)));
            boolean same = each.expression(1).getText().equals(entry.expression(1).getText());
            if (!same && !toldOverlap) {
                toldOverlap = true;
                lacks.note(
                        Lack.MAP_NOTE,
                        entry,
                        "this entry and one before it may be true together and demand different"
                                + " things; the first one counts here");
            }
        }
        String guard = parts.size() == 1 ? Guards.bare(parts.get(0)) : String.join(" && ", parts);
        return "mapping [" + guard + "] / {" + messages(entry.expression(1), right) + "};\n";
    }

    /** What the reference gets or sends, from a conjunction of ports with their messages. */
    private String messages(ExpressionContext demanded, ExpressionWriter right) {
        List<String> messages = new ArrayList<>();
        for (ExpressionContext each : Guards.parts(demanded)) {
            if (each instanceof BinaryExpressionContext equal
                    && equal.op.getText().equals("==")
                    && equal.expression(0) instanceof NameExpressionContext) {
                messages.add(
                        right.write(equal.expression(0))
                                + " = "
                                + right.write(equal.expression(1)));
            } else {
                lacks.missing(
                        Lack.MAP,
                        each,
                        "what an entry demands of the reference is the message of a port, or '[]'"
                                + " for none");
            }
        }
        return String.join(", ", messages);
    }

    /** Expressions of a map: lists have one message or none, and a port may have a namesake. */
    private final class Writer extends ExpressionWriter {
        private final MapSide side;
        private final MapSide other;

        Writer(Set<String> ports, MapSide side, MapSide other) {
            super(Scope.ofPorts(ports, lacks));
            this.side = side;
            this.other = other;
        }

        @Override
        public String port(String port) {
            if (!side.hasPort(port)) {
                lacks.missing(
                        Lack.MAP,
                        lacks.whole(),
                        "'%s' has no port '%s'".formatted(side.name(), port));
            }
            return other.hasPort(port) ? port + "Of" + side.name() : port;
        }

        @Override
        public String write(ExpressionContext expression) {
            if (expression instanceof ListExpressionContext list) {
                return list.expression().isEmpty()
                        ? "--"
                        : list.expression().size() == 1 ? write(list.expression(0)) : unknown(list);
            }
            return super.write(expression);
        }

        @Override
        protected String member(MemberExpressionContext member) {
            return member.name().getText();
        }

        @Override
        protected boolean isConstant(MemberExpressionContext member) {
            return true;
        }
    }
}
