package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.source.Lack;
import montiarc7.statement.Deed.Block;
import montiarc7.statement.Deed.Choice;
import montiarc7.statement.Deed.Said;
import montiarc7.statement.Deed.Sent;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * What is sent in one step. Each assignment to a port sends a message in MontiArc, and in Arcomat
 * the last one counts: where a port sends several, which only events allow, they are said together
 * at the end of each way through the choices.
 */
final class Sending {
    private static final int MOST_WAYS = 64;

    /**
     * Conditions that were asked on a way, of inputs that are there.
     *
     * @param held those that were true
     * @param failed those that were false
     */
    private record Asked(List<ExpressionContext> held, List<ExpressionContext> failed) {
        Asked and(Optional<ExpressionContext> asked, boolean holds) {
            List<ExpressionContext> more = new ArrayList<>(holds ? held : failed);
            asked.ifPresent(more::add);
            return holds ? new Asked(more, failed) : new Asked(held, more);
        }

        boolean isTrue(ExpressionContext asked, Guards guards) {
            return held.stream().anyMatch(each -> guards.follows(asked, each));
        }

        boolean isFalse(ExpressionContext asked, Guards guards) {
            if (Choices.bare(asked) instanceof BinaryExpressionContext either
                    && either.op.getText().equals("||")) {
                return either.expression().stream().allMatch(each -> isFalse(each, guards));
            }
            return held.stream().anyMatch(each -> guards.exclude(each, asked))
                    || failed.stream().anyMatch(each -> guards.follows(each, asked));
        }
    }

    private final Scope scope;
    private final Guards guards;
    private final ParserRuleContext place;
    private Set<String> several = Set.of();
    private int ways = 1;
    private int stored;

    Sending(Scope scope, ParserRuleContext place) {
        this.scope = scope;
        this.guards = new Guards(new ExpressionWriter(scope));
        this.place = place;
    }

    List<Deed> together(List<Deed> deeds) {
        Map<String, Integer> most = most(deeds);
        several = new HashSet<>(most.keySet());
        several.removeIf(port -> most.get(port) < 2);
        if (!several.isEmpty() && scope.events()) {
            return way(deeds, Map.of(), new Asked(List.of(), List.of()));
        }
        several.forEach(
                port ->
                        refuse(
                                "'%s' is sent more than once in one step; a port of Arcomat carries one message in a slice"
                                        .formatted(port)));
        return deeds;
    }

    private void refuse(String message) {
        scope.lacks().missing(Lack.SENT_TWICE, place, message);
    }

    /** How often each output port is sent at most. */
    private Map<String, Integer> most(List<Deed> deeds) {
        Map<String, Integer> all = new HashMap<>();
        Map<String, Integer> one = new HashMap<>();
        List<ExpressionContext> apart = new ArrayList<>();
        for (Deed each : deeds) {
            Optional<ExpressionContext> condition = apartFrom(each, apart);
            condition.ifPresent(apart::add);
            boolean isApart = condition.isPresent();
            most(each)
                    .forEach(
                            (port, count) ->
                                    (isApart ? one : all)
                                            .merge(
                                                    port,
                                                    count,
                                                    isApart ? Integer::max : Integer::sum));
        }
        one.forEach((port, count) -> all.merge(port, count, Integer::sum));
        return all;
    }

    private Map<String, Integer> most(Deed deed) {
        if (deed instanceof Sent sent && !sent.value().equals("--")) {
            return Map.of(sent.port(), 1);
        } else if (deed instanceof Block block) {
            return most(block.inside());
        } else if (deed instanceof Choice choice) {
            Map<String, Integer> all = most(choice.then());
            most(choice.otherwise()).forEach((port, count) -> all.merge(port, count, Integer::max));
            return all;
        }
        return Map.of();
    }

    /**
     * Choices about inputs of which at most one is made, which what is done between them cannot
     * change.
     */
    private Optional<ExpressionContext> apartFrom(Deed deed, List<ExpressionContext> others) {
        return deed instanceof Choice choice && choice.otherwise().isEmpty()
                ? choice.condition()
                        .original()
                        .filter(
                                each ->
                                        others.stream()
                                                .allMatch(other -> guards.exclude(other, each)))
                : Optional.empty();
    }

    private boolean isConcerned(Deed deed) {
        return most(deed).keySet().stream().anyMatch(several::contains);
    }

    /**
     * @param before what has been sent on the way
     * @param asked what is known there of inputs
     */
    private List<Deed> way(List<Deed> deeds, Map<String, List<String>> before, Asked asked) {
        List<Deed> all = new ArrayList<>();
        Map<String, List<String>> sent = new LinkedHashMap<>(before);
        for (int i = 0; i < deeds.size(); i++) {
            Deed each = deeds.get(i);
            List<Deed> rest = deeds.subList(i + 1, deeds.size());
            if (each instanceof Sent message && several.contains(message.port())) {
                add(message, rest, sent, all);
            } else if (each instanceof Block block && isConcerned(each)) {
                all.addAll(way(followed(block.inside(), rest), sent, asked));
                return all;
            } else if (each instanceof Choice choice && isConcerned(each)) {
                all.addAll(choice(choice, rest, sent, asked));
                return all;
            } else {
                all.add(each);
            }
        }
        sent.forEach((port, values) -> all.add(new Sent(port, list(values), Set.of())));
        return all;
    }

    private static String list(List<String> values) {
        return values.size() == 1 ? values.get(0) : "[" + String.join(", ", values) + "]";
    }

    private void add(
            Sent message, List<Deed> rest, Map<String, List<String>> sent, List<Deed> all) {
        if (message.value().equals("--")) {
            return;
        }
        String value = message.value();
        if (rest.stream().anyMatch(each -> changes(each, message.reads()))) {
            value = stored(message, all);
        }
        List<String> values = new ArrayList<>(sent.getOrDefault(message.port(), List.of()));
        values.add(value);
        sent.put(message.port(), values);
    }

    private static boolean changes(Deed deed, Set<String> names) {
        if (deed instanceof Said said) {
            return names.contains(said.changed());
        } else if (deed instanceof Block block) {
            return block.inside().stream().anyMatch(each -> changes(each, names));
        } else if (deed instanceof Choice choice) {
            return choice.then().stream().anyMatch(each -> changes(each, names))
                    || choice.otherwise().stream().anyMatch(each -> changes(each, names));
        }
        return false;
    }

    /** What is changed later is kept as it is now. */
    private String stored(Sent message, List<Deed> all) {
        Optional<String> type =
                Optional.ofNullable(scope.declared().get(message.port()))
                        .map(scope.types()::message);
        if (type.isEmpty()) {
            refuse(
                    "'%s' is sent more than once in one step, and is declared elsewhere; declare it here"
                            .formatted(message.port()));
        }
        String name;
        do {
            stored++;
            name = message.port() + stored;
        } while (scope.lacks().says(name));
        all.add(
                new Said(
                        type.orElse("Integer") + " " + name + " = " + message.value(), name, true));
        return name;
    }

    private List<Deed> choice(
            Choice choice, List<Deed> rest, Map<String, List<String>> sent, Asked before) {
        Optional<ExpressionContext> asked = choice.condition().original().filter(this::isDefined);
        if (asked.isPresent() && before.isTrue(asked.get(), guards)) {
            return way(followed(choice.then(), rest), sent, before);
        }
        if (asked.isPresent() && before.isFalse(asked.get(), guards)) {
            return way(followed(choice.otherwise(), rest), sent, before);
        }
        ways++;
        if (ways > MOST_WAYS) {
            refuse(
                    "there are more than %d ways through what is sent here; take it apart"
                            .formatted(MOST_WAYS));
            return List.of();
        }
        return List.of(
                new Choice(
                        choice.condition(),
                        way(followed(choice.then(), rest), sent, before.and(asked, true)),
                        way(followed(choice.otherwise(), rest), sent, before.and(asked, false))));
    }

    /** Whether it is true or false, whatever else may be: all that it reads is there. */
    private boolean isDefined(ExpressionContext condition) {
        return scope.present()
                .containsAll(
                        Names.in(condition).stream().filter(scope.inputs()::contains).toList());
    }

    /** Where names end with a block that is gone on with, they must not be those of others. */
    private List<Deed> followed(List<Deed> inside, List<Deed> rest) {
        String text = Deed.text(rest);
        for (Deed each : inside) {
            if (each instanceof Said said
                    && said.declares()
                    && Pattern.compile("\\b" + Pattern.quote(said.changed()) + "\\b")
                            .matcher(text)
                            .find()) {
                refuse(
                        "ports are sent more than once where several things are called '%s'; give each a name of its own"
                                .formatted(said.changed()));
            }
        }
        List<Deed> all = new ArrayList<>(inside);
        all.addAll(rest);
        return all;
    }
}
