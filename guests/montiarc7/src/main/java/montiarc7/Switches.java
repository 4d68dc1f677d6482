package montiarc7;

import montiarc7.grammar.MontiArc7Parser.ArgumentContext;
import montiarc7.grammar.MontiArc7Parser.ArgumentsContext;
import montiarc7.grammar.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BracketExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.ConstraintElementContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.NameExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ParameterContext;
import montiarc7.grammar.MontiArc7Parser.VariationElementContext;
import montiarc7.source.Folder;
import montiarc7.source.Placed;

import org.antlr.v4.runtime.tree.ParseTree;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Parameters that decide nothing but variants are features here, since variants are chosen before
 * anything runs: of a truth value one, of an enumeration one for each of its constants.
 */
final class Switches {
    private static final int MOST_CONSTANTS = 6;

    private final List<ParameterContext> parameters;

    /** Parameters that are switches, with constants where these are of an enumeration. */
    private final Map<String, List<String>> switches = new HashMap<>();

    /**
     * A feature that stands for a parameter.
     *
     * @param constant which the parameter is where the feature is chosen; none of a truth value
     */
    record Choice(String feature, String parameter, Optional<String> constant) {}

    Switches(ComponentContext component, Folder folder) {
        this.parameters =
                component.parameters() == null ? List.of() : component.parameters().parameter();
        Set<String> deciding = new HashSet<>();
        Set<String> read = new HashSet<>();
        collect(component, false, deciding, read);
        for (ParameterContext each : parameters) {
            String name = each.name().getText();
            if (deciding.contains(name) && !read.contains(name)) {
                constants(each, component, folder).ifPresent(all -> switches.put(name, all));
            }
        }
    }

    private static void collect(
            ParseTree tree, boolean decides, Set<String> deciding, Set<String> read) {
        if (tree instanceof NameExpressionContext name) {
            (decides ? deciding : read).add(name.getText());
        }
        if (tree instanceof VariationElementContext variation && Placed.isDecided(variation)) {
            Placed.decided(variation).forEach(each -> collect(each, false, deciding, read));
            return;
        }
        boolean isCondition =
                tree instanceof VariationElementContext || tree instanceof ConstraintElementContext;
        for (int i = 0; i < tree.getChildCount(); i++) {
            ParseTree child = tree.getChild(i);
            boolean inside = child instanceof ExpressionContext && isCondition;
            collect(child, inside || decides, deciding, read);
        }
    }

    /** No constants of a truth value; nothing where it is no switch. */
    private static Optional<List<String>> constants(
            ParameterContext parameter, ComponentContext component, Folder folder) {
        String type = parameter.type().getText();
        if (type.matches("(java\\.lang\\.)?[bB]oolean")) {
            return Optional.of(List.of());
        }
        return folder.constants(type.substring(type.lastIndexOf('.') + 1))
                .filter(all -> all.size() <= MOST_CONSTANTS)
                .filter(all -> isAskedOnly(parameter.name().getText(), all, component));
    }

    /** Whether a parameter is compared with constants, and nothing else is done with it. */
    private static boolean isAskedOnly(String name, List<String> constants, ParseTree tree) {
        if (tree instanceof BinaryExpressionContext binary
                && asked(binary, name).filter(each -> constants.contains(last(each))).isPresent()) {
            return true;
        }
        if (tree instanceof NameExpressionContext && tree.getText().equals(name)) {
            return false;
        }
        for (int i = 0; i < tree.getChildCount(); i++) {
            if (!isAskedOnly(name, constants, tree.getChild(i))) {
                return false;
            }
        }
        return true;
    }

    /** With what a name is compared. */
    private static Optional<ExpressionContext> asked(BinaryExpressionContext binary, String name) {
        if (!binary.op.getText().matches("[!=]=")) {
            return Optional.empty();
        }
        ExpressionContext left = bare(binary.expression(0));
        ExpressionContext right = bare(binary.expression(1));
        return left.getText().equals(name)
                ? Optional.of(right)
                : Optional.of(left).filter(each -> right.getText().equals(name));
    }

    private static ExpressionContext bare(ExpressionContext expression) {
        return expression instanceof BracketExpressionContext bracket
                ? bare(bracket.expression())
                : expression;
    }

    private static String last(ExpressionContext constant) {
        String text = constant.getText();
        return text.substring(text.lastIndexOf('.') + 1);
    }

    Set<String> names() {
        return choices().stream().map(Choice::feature).collect(Collectors.toSet());
    }

    /** In the order of the text. */
    List<Choice> choices() {
        List<Choice> all = new ArrayList<>();
        for (ParameterContext each : parameters) {
            String name = each.name().getText();
            if (isOne(each) && switches.get(name).isEmpty()) {
                all.add(new Choice(name, name, Optional.empty()));
            } else if (isOne(each)) {
                switches.get(name)
                        .forEach(
                                constant ->
                                        all.add(
                                                new Choice(
                                                        feature(name, constant),
                                                        name,
                                                        Optional.of(constant))));
            }
        }
        return all;
    }

    private static String feature(String parameter, String constant) {
        return parameter + "Is" + constant;
    }

    /** Constraints that say of each parameter that it is one of its constants. */
    String constraints() {
        StringBuilder text = new StringBuilder();
        for (ParameterContext each : parameters) {
            String name = each.name().getText();
            List<String> features =
                    switches.getOrDefault(name, List.of()).stream()
                            .map(constant -> feature(name, constant))
                            .toList();
            if (!features.isEmpty()) {
                text.append("constraint (").append(exactlyOne(features)).append(");\n");
            }
        }
        return text.toString();
    }

    private static String exactlyOne(List<String> features) {
        List<String> parts = new ArrayList<>();
        parts.add("(" + String.join(" || ", features) + ")");
        for (int i = 0; i < features.size(); i++) {
            for (String other : features.subList(i + 1, features.size())) {
                parts.add("!(" + features.get(i) + " && " + other + ")");
            }
        }
        return String.join(" && ", parts);
    }

    /** The feature that says what a comparison asks; nothing where it compares something else. */
    Optional<String> comparison(BinaryExpressionContext binary) {
        for (Choice each : choices()) {
            Optional<String> constant = asked(binary, each.parameter()).map(Switches::last);
            if (each.constant().isPresent() && each.constant().equals(constant)) {
                String sign = binary.op.getText().equals("==") ? "" : "!";
                return Optional.of(sign + each.feature());
            }
        }
        return Optional.empty();
    }

    /** Of a parameter of an enumeration, whether an argument is the constant; nothing of others. */
    Optional<Boolean> isConstant(ExpressionContext argument, Choice asked) {
        return Optional.of(last(argument))
                .filter(switches.get(asked.parameter())::contains)
                .map(each -> asked.constant().equals(Optional.of(each)));
    }

    boolean isOne(ParameterContext parameter) {
        return switches.containsKey(parameter.name().getText());
    }

    /** Whether an argument, the one at some place, is that of a switch. */
    boolean isFor(ArgumentContext argument, int place) {
        return argument.name() == null
                ? place < parameters.size() && isOne(parameters.get(place))
                : switches.containsKey(argument.name().getText());
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
