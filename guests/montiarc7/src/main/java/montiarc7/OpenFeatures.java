package montiarc7;

import montiarc7.grammar.MontiArc7Parser.ArgumentContext;
import montiarc7.grammar.MontiArc7Parser.ArgumentsContext;
import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.FeatureElementContext;
import montiarc7.grammar.MontiArc7Parser.InnerElementContext;
import montiarc7.grammar.MontiArc7Parser.InstanceContext;
import montiarc7.grammar.MontiArc7Parser.InstanceElementContext;
import montiarc7.source.Folder;
import montiarc7.source.Placed;
import montiarc7.statement.Choices;

import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Features of parts that nothing chooses: they are open in MontiArc, for whoever configures the
 * whole, and so they are features of the whole here.
 */
final class OpenFeatures {
    private final Folder folder;
    private final Set<ComponentContext> begun;

    private OpenFeatures(Folder folder, Set<ComponentContext> begun) {
        this.folder = folder;
        this.begun = begun;
    }

    /** How 'part.feature' is called as a feature of the component; none of one within another. */
    static Map<String, String> of(ComponentContext component, Folder folder) {
        return component.getParent() instanceof InnerElementContext
                ? Map.of()
                : new OpenFeatures(folder, new HashSet<>()).open(component);
    }

    /** All features that a component of a file has here, but for those that were parameters. */
    static Set<String> all(ComponentContext component, Folder folder) {
        return new OpenFeatures(folder, new HashSet<>()).features(component);
    }

    /** Those that it declares. */
    static Set<String> declared(ComponentContext component) {
        Set<String> names = new TreeSet<>();
        for (Placed each : Placed.of(component.element())) {
            if (each.element() instanceof FeatureElementContext features) {
                features.name().forEach(name -> names.add(name.getText()));
            }
        }
        return names;
    }

    private Set<String> features(ComponentContext component) {
        Set<String> names = declared(component);
        names.addAll(open(component).values());
        return names;
    }

    private Map<String, String> open(ComponentContext component) {
        Map<String, String> open = new TreeMap<>();
        if (begun.add(component)) {
            Choices choices = new Choices(component);
            for (Placed each : Placed.of(component.element())) {
                if (each.element() instanceof InstanceElementContext parts) {
                    folder.component(parts.type().qname().getText())
                            .ifPresent(type -> add(parts, features(type), choices, open));
                }
            }
            begun.remove(component);
        }
        return open;
    }

    private static void add(
            InstanceElementContext parts,
            Set<String> features,
            Choices choices,
            Map<String, String> open) {
        for (InstanceContext each : parts.instance()) {
            String part = each.name().getText();
            ArgumentsContext given = arguments(parts, each);
            for (String feature : features) {
                if (argument(feature, given).isEmpty() && choices.of(part, feature).isEmpty()) {
                    open.put(part + "." + feature, part + capital(feature));
                }
            }
        }
    }

    /** Those of one part, or of all that are declared with it; null if there are none. */
    static ArgumentsContext arguments(InstanceElementContext parts, InstanceContext part) {
        return part.arguments() == null ? parts.arguments() : part.arguments();
    }

    /** What an argument chooses for a feature. */
    static Optional<ExpressionContext> argument(String feature, ArgumentsContext given) {
        return given == null
                ? Optional.empty()
                : given.argument().stream()
                        .filter(each -> each.name() != null)
                        .filter(each -> each.name().getText().equals(feature))
                        .map(ArgumentContext::expression)
                        .findFirst();
    }

    private static String capital(String name) {
        return name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1);
    }
}
