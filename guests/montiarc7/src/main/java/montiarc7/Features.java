package montiarc7;

import montiarc7.grammar.MontiArc7Parser.ArgumentsContext;
import montiarc7.grammar.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BracketExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.ConstraintElementContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.InstanceElementContext;
import montiarc7.grammar.MontiArc7Parser.PrefixExpressionContext;
import montiarc7.source.Constants;
import montiarc7.source.Folder;
import montiarc7.source.Lack;
import montiarc7.source.Lacks;
import montiarc7.source.Placed;
import montiarc7.statement.Choices;
import montiarc7.statement.Guards;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** The features of a component, the conditions about them, and those of its parts. */
final class Features {
    private final ComponentContext component;
    private final Folder folder;
    private final Lacks lacks;
    private final Switches switches;
    private final Choices choices;

    /** What stands for its own features. */
    private final Map<String, String> own = new HashMap<>();

    /** By 'part.feature'. */
    private final Map<String, String> open;

    Features(ComponentContext component, Folder folder, Lacks lacks) {
        this.folder = folder;
        this.lacks = lacks;
        this.switches = new Switches(component, folder);
        this.choices = new Choices(component);
        this.open = new TreeMap<>(OpenFeatures.of(component, folder));
        this.component = component;
        OpenFeatures.declared(component).forEach(each -> own.put(each, each));
        switches.names().forEach(each -> own.put(each, each));
    }

    /** Of a part, where each of its features is what is said of it around. */
    private Features(
            ComponentContext part, Folder folder, Lacks lacks, Map<String, String> values) {
        this(part, folder, lacks);
        own.putAll(values);
        open.replaceAll((feature, name) -> values.getOrDefault(name, name));
    }

    /** Features that are those of parts in the original. */
    Collection<String> open() {
        return open.values();
    }

    /** What a part is told, where it has features that its arguments leave open. */
    List<String> arguments(
            String part, ComponentContext type, ArgumentsContext given, ParserRuleContext place) {
        Set<String> parameters = new Switches(type, folder).names();
        return values(part, type, given, place).entrySet().stream()
                .filter(
                        each ->
                                parameters.contains(each.getKey())
                                        || OpenFeatures.argument(each.getKey(), given).isEmpty())
                .map(each -> each.getKey() + " = " + each.getValue())
                .toList();
    }

    /** What the features of a part are. */
    private Map<String, String> values(
            String part, ComponentContext type, ArgumentsContext given, ParserRuleContext place) {
        Map<String, String> all = new LinkedHashMap<>();
        for (String feature : OpenFeatures.all(type, folder)) {
            all.put(
                    feature,
                    OpenFeatures.argument(feature, given)
                            .map(this::condition)
                            .orElseGet(() -> choice(part, feature, place)));
        }
        Switches others = new Switches(type, folder);
        for (Switches.Choice each : others.choices()) {
            all.put(each.feature(), choice(part, each, others, given, place));
        }
        return all;
    }

    /** The constraints of a part about what is open in it: they are those of the whole, too. */
    List<String> constraints(
            String part, ComponentContext type, ArgumentsContext given, ParserRuleContext place) {
        if (open.keySet().stream().noneMatch(each -> each.startsWith(part + "."))) {
            return List.of();
        }
        Map<String, String> values = values(part, type, given, place);
        values.replaceAll((feature, value) -> value.matches("\\w+") ? value : "(" + value + ")");
        Lacks unheard = lacks.unheard();
        List<String> constraints = new Features(type, folder, unheard, values).constraints();
        if (unheard.isAny()) {
            nothingSays(
                    place,
                    "'%s' has features that nothing chooses, and constraints that cannot be converted; choose its features"
                            .formatted(part));
        }
        return constraints;
    }

    /** All of them, those of its parts too. */
    private List<String> constraints() {
        List<String> all = new ArrayList<>();
        for (Placed each : Placed.of(component.element())) {
            List<String> here = new ArrayList<>();
            if (each.element() instanceof ConstraintElementContext constraint) {
                left(constraint).ifPresent(here::add);
            } else if (each.element() instanceof InstanceElementContext parts) {
                here.addAll(constraints(parts));
            }
            String sides =
                    each.sides().stream().map(this::side).collect(Collectors.joining(" && "));
            here.forEach(
                    one ->
                            all.add(
                                    sides.isEmpty()
                                            ? one
                                            : "(" + sides + ") implies (" + one + ")"));
        }
        return all;
    }

    private String side(Placed.Side side) {
        String condition = "(" + condition(side.variation().expression()) + ")";
        return side.holds() ? condition : "!" + condition;
    }

    /** Of all parts of a declaration. */
    List<String> constraints(InstanceElementContext parts) {
        Optional<ComponentContext> type = folder.component(parts.type().qname().getText());
        return parts.instance().stream()
                .flatMap(
                        each ->
                                type.stream()
                                        .flatMap(
                                                known ->
                                                        constraints(
                                                                each.name().getText(),
                                                                known,
                                                                OpenFeatures.arguments(parts, each),
                                                                each)
                                                                .stream()))
                .toList();
    }

    private String choice(String part, String feature, ParserRuleContext place) {
        Optional<ExpressionContext> condition = choices.of(part, feature);
        if (condition.isPresent()) {
            return choice(condition.get());
        }
        String name = open.get(part + "." + feature);
        if (name == null) {
            return nothingSays(
                    place,
                    "nothing says whether '%s' has '%s'; write '%s = true', or 'false', or name a feature that decides"
                            .formatted(part, feature, feature));
        }
        lacks.note(
                Lack.OPEN,
                place,
                "nothing chooses '%s' of '%s'; it stays open, as the feature '%s' of the whole"
                        .formatted(feature, part, name));
        return name;
    }

    private String choice(
            String part,
            Switches.Choice asked,
            Switches others,
            ArgumentsContext given,
            ParserRuleContext place) {
        Optional<ExpressionContext> value = others.value(asked.parameter(), given);
        Optional<String> choice =
                asked.constant().isEmpty()
                        ? value.map(this::condition)
                        : value.flatMap(each -> others.isConstant(each, asked))
                                .map(String::valueOf);
        return choice.orElseGet(
                () ->
                        nothingSays(
                                place,
                                "nothing says what '%s' of '%s' is; give it"
                                        .formatted(asked.parameter(), part)));
    }

    private String nothingSays(ParserRuleContext place, String message) {
        lacks.missing(Lack.VARIABILITY, place, message);
        return "true";
    }

    /** Of '!part.f' and 'part.f' what is chosen stands in the constraint itself. */
    private String choice(ExpressionContext expression) {
        if (Choices.isOfPart(expression)) {
            return "true";
        }
        return expression instanceof PrefixExpressionContext prefix
                        && Choices.isOfPart(Choices.bare(prefix.expression()))
                ? "false"
                : condition(expression);
    }

    /** What is left of a constraint when it has chosen features of parts; empty if nothing is. */
    String constraint(ConstraintElementContext constraint) {
        return left(constraint).map(each -> "constraint (" + each + ");\n").orElse("");
    }

    private Optional<String> left(ConstraintElementContext constraint) {
        List<String> left =
                Guards.parts(constraint.expression()).stream()
                        .filter(each -> Choices.ofPart(each).isEmpty())
                        .filter(each -> !Constants.truth(each).equals(Optional.of(true)))
                        .map(this::condition)
                        .toList();
        return Optional.of(String.join(" && ", left)).filter(each -> !left.isEmpty());
    }

    /** A condition, of features and nothing else. */
    String condition(ExpressionContext expression) {
        Optional<Boolean> constant = Constants.truth(expression);
        if (constant.isPresent()) {
            return constant.get().toString();
        } else if (expression instanceof BracketExpressionContext bracket) {
            return "(" + condition(bracket.expression()) + ")";
        } else if (expression instanceof PrefixExpressionContext prefix
                && prefix.op.getText().equals("!")) {
            return "!" + condition(prefix.expression());
        } else if (expression instanceof BinaryExpressionContext binary) {
            return switches.comparison(binary).map(this::own).orElseGet(() -> both(binary));
        } else if (own.containsKey(expression.getText())) {
            return own.get(expression.getText());
        }
        String part = open.get(expression.getText());
        return part == null ? unknown(expression) : part;
    }

    private String own(String feature) {
        return feature.startsWith("!") ? "!" + own.get(feature.substring(1)) : own.get(feature);
    }

    private String both(BinaryExpressionContext binary) {
        String operator = binary.op.getText();
        if (!operator.matches("&&|\\|\\||implies|<=>|==|!=")) {
            return unknown(binary);
        }
        String left = condition(binary.expression(0));
        String right = condition(binary.expression(1));
        return switch (operator) {
            case "==" -> "(" + left + " <=> " + right + ")";
            case "!=" -> "!(" + left + " <=> " + right + ")";
            default -> left + " " + operator + " " + right;
        };
    }

    private String unknown(ExpressionContext expression) {
        lacks.missing(
                Lack.VARIABILITY,
                expression,
                "'%s' is no feature of this component; conditions of Arcomat speak of features, which are chosen before anything runs"
                        .formatted(expression.getText()));
        return "true";
    }
}
