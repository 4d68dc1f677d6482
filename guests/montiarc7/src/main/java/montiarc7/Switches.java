package montiarc7;

import montiarc7.MontiArc7Parser.ArgumentContext;
import montiarc7.MontiArc7Parser.ArgumentsContext;
import montiarc7.MontiArc7Parser.ComponentContext;
import montiarc7.MontiArc7Parser.ConstraintElementContext;
import montiarc7.MontiArc7Parser.ExpressionContext;
import montiarc7.MontiArc7Parser.NameExpressionContext;
import montiarc7.MontiArc7Parser.ParameterContext;
import montiarc7.MontiArc7Parser.VariationElementContext;

import org.antlr.v4.runtime.tree.ParseTree;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Parameters that are truth values and decide nothing but variants are features here, since
 * variants are chosen before anything runs.
 */
final class Switches {
    private final List<ParameterContext> parameters;
    private final Set<String> names = new HashSet<>();

    Switches(ComponentContext component) {
        this.parameters =
                component.parameters() == null ? List.of() : component.parameters().parameter();
        Set<String> deciding = new HashSet<>();
        Set<String> read = new HashSet<>();
        collect(component, false, deciding, read);
        for (ParameterContext each : parameters) {
            String name = each.name().getText();
            if (each.type().getText().matches("(java\\.lang\\.)?[bB]oolean")
                    && deciding.contains(name)
                    && !read.contains(name)) {
                names.add(name);
            }
        }
    }

    private static void collect(
            ParseTree tree, boolean decides, Set<String> deciding, Set<String> read) {
        if (tree instanceof NameExpressionContext name) {
            (decides ? deciding : read).add(name.getText());
        }
        boolean isCondition =
                tree instanceof VariationElementContext || tree instanceof ConstraintElementContext;
        for (int i = 0; i < tree.getChildCount(); i++) {
            ParseTree child = tree.getChild(i);
            boolean inside = child instanceof ExpressionContext && isCondition;
            collect(child, inside || decides, deciding, read);
        }
    }

    Set<String> names() {
        return names;
    }

    boolean isOne(ParameterContext parameter) {
        return names.contains(parameter.name().getText());
    }

    /** Whether an argument, the one at some place, is that of a switch. */
    boolean isFor(ArgumentContext argument, int place) {
        return argument.name() == null
                ? place < parameters.size() && isOne(parameters.get(place))
                : names.contains(argument.name().getText());
    }

    /** What a switch is set to: by an argument, or else by its default. */
    Optional<ExpressionContext> value(String name, ArgumentsContext given) {
        Optional<ExpressionContext> found = Optional.empty();
        for (int i = 0; i < parameters.size(); i++) {
            if (parameters.get(i).name().getText().equals(name)) {
                found = Optional.ofNullable(parameters.get(i).expression());
                if (given != null
                        && i < given.argument().size()
                        && given.argument(i).name() == null) {
                    found = Optional.of(given.argument(i).expression());
                }
            }
        }
        if (given != null) {
            for (ArgumentContext each : given.argument()) {
                if (each.name() != null && each.name().getText().equals(name)) {
                    found = Optional.of(each.expression());
                }
            }
        }
        return found;
    }
}
