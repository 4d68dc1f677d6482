package montiarc7;

import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.FieldElementContext;
import montiarc7.grammar.MontiArc7Parser.PortsElementContext;
import montiarc7.grammar.MontiArc7Parser.TypeContext;
import montiarc7.source.Placed;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The types of what a component declares itself: ports, fields and parameters. */
final class Declared {
    private Declared() {}

    static Map<String, TypeContext> in(ComponentContext component, List<Placed.Side> sides) {
        Map<String, TypeContext> all = new HashMap<>();
        if (component.parameters() != null) {
            component
                    .parameters()
                    .parameter()
                    .forEach(each -> all.put(each.name().getText(), each.type()));
        }
        for (Placed each : Placed.of(component.element())) {
            if (!each.goesWith(sides)) {
                continue;
            }
            if (each.element() instanceof PortsElementContext ports) {
                ports.portDeclaration()
                        .forEach(
                                port ->
                                        port.name()
                                                .forEach(
                                                        name ->
                                                                all.put(
                                                                        name.getText(),
                                                                        port.type())));
            } else if (each.element() instanceof FieldElementContext fields) {
                fields.field().forEach(field -> all.put(field.name().getText(), fields.type()));
            }
        }
        return all;
    }
}
