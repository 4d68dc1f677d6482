package montiarc7;

import montiarc7.grammar.MontiArc7Parser.ArgumentContext;
import montiarc7.grammar.MontiArc7Parser.ArgumentsContext;
import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.InstanceContext;
import montiarc7.grammar.MontiArc7Parser.InstanceElementContext;
import montiarc7.source.Folder;
import montiarc7.statement.ExpressionWriter;
import montiarc7.statement.Scope;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Parts, with what they are given: arguments, and choices of their features. */
final class PartWriter {
    private final Folder folder;
    private final Scope scope;
    private final Features features;

    PartWriter(Folder folder, Scope scope, Features features) {
        this.folder = folder;
        this.scope = scope;
        this.features = features;
    }

    String write(InstanceElementContext parts) {
        String type = scope.types().component(parts.type());
        Optional<ComponentContext> known = folder.component(parts.type().qname().getText());
        StringBuilder written = new StringBuilder();
        for (InstanceContext each : parts.instance()) {
            ArgumentsContext own = OpenFeatures.arguments(parts, each);
            String name = each.name().getText();
            List<String> given =
                    arguments(own, known.map(component -> new Switches(component, folder)));
            known.ifPresent(
                    component -> given.addAll(features.arguments(name, component, own, each)));
            written.append("component ").append(type).append(inBrackets(given));
            written.append(' ').append(name).append(";\n");
        }
        features.constraints(parts)
                .forEach(each -> written.append("constraint (").append(each).append(");\n"));
        return written.toString();
    }

    /** What a component gives to the one that it extends. */
    String given(ArgumentsContext arguments) {
        return inBrackets(arguments(arguments, Optional.empty()));
    }

    /** Those that set no switch. */
    private List<String> arguments(ArgumentsContext arguments, Optional<Switches> switches) {
        List<String> all = new ArrayList<>();
        for (int i = 0; arguments != null && i < arguments.argument().size(); i++) {
            ArgumentContext each = arguments.argument(i);
            int place = i;
            if (switches.filter(known -> known.isFor(each, place)).isEmpty()) {
                String name = each.name() == null ? "" : each.name().getText() + " = ";
                all.add(name + new ExpressionWriter(scope).write(each.expression()));
            }
        }
        return all;
    }

    private static String inBrackets(List<String> arguments) {
        return arguments.isEmpty() ? "" : "(" + String.join(", ", arguments) + ")";
    }
}
