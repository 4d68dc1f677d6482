package arcomat.analysis.evolution;

import arcomat.analysis.refinement.Interfaces;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Vacuity;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Parameter;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Arguments;
import arcomat.semantics.network.Network;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/**
 * How a component compares with what it was: does it keep what it promised, and does it promise
 * more? Both are compared with the same arguments.
 *
 * @param mark what follows the name of the old one in sentences, to tell it from the new one
 * @param budgets a new one for each comparison
 */
public record VersionComparison(
        Component old, String mark, Component fresh, Supplier<Budget> budgets) {

    /**
     * @param given arguments to compare with, beside the defaults
     */
    public Change with(Set<List<Value>> given) {
        Optional<Sentence> problem = parameterProblem();
        if (problem.isPresent()) {
            Verdict verdict = Verdict.fails("interface", List.of(problem.get()));
            return Change.of(List.of(forward(List.of(), verdict)), List.of());
        }
        Set<List<Value>> arguments = new LinkedHashSet<>();
        if (old.hasDefaults()) {
            arguments.add(List.of());
        }
        arguments.addAll(given);
        if (arguments.isEmpty()) {
            return compareInterfaces();
        }
        try {
            return compareWith(arguments);
        } catch (ModelError argumentsGoWrong) {
            return Change.unknown(String.valueOf(argumentsGoWrong.getMessage()));
        }
    }

    /**
     * Ports are the same whatever the arguments are, and so is a promise of nothing. Whether a side
     * can begin is not asked: that depends on them.
     */
    private Change compareInterfaces() {
        Promise before = new Promise(old, List.of(), automata(old)).marked(mark);
        Promise after = new Promise(fresh, List.of(), automata(fresh));
        return Change.of(
                List.of(forward(List.of(), compareInterfaces(after, before))),
                List.of(backward(List.of(), compareInterfaces(before, after))));
    }

    private static Verdict compareInterfaces(Promise left, Promise right) {
        return Interfaces.compare(left, right)
                .orElseGet(
                        () ->
                                promisesNothing(right)
                                        ? Vacuity.nothingAsked()
                                        : Verdict.unknown(
                                                "it takes arguments, and no instance tells which;"
                                                        + " give its parameters defaults"));
    }

    private Change compareWith(Set<List<Value>> arguments) {
        List<Change.Witness> forward = new ArrayList<>();
        List<Change.Witness> backward = new ArrayList<>();
        for (List<Value> each : arguments) {
            Promise before = promise(old, each).marked(mark);
            Promise after = promise(fresh, each);
            forward.add(forward(each, check(after, before)));
            backward.add(backward(each, check(before, after)));
        }
        return Change.of(forward, backward);
    }

    private Verdict check(Promise left, Promise right) {
        List<Sentence> devices = deviceChanges(right, left);
        if (!devices.isEmpty()) {
            return Verdict.fails("interface", devices);
        }
        return promisesNothing(right)
                ? Refinement.comparable(left, right).orElseGet(Vacuity::nothingAsked)
                : Refinement.check(left, right, budgets.get());
    }

    /**
     * A sentence for each device of the old one that is something else in the new one: a motor at
     * another port of the brick is another motor. Ports are compared elsewhere.
     */
    private static List<Sentence> deviceChanges(Promise old, Promise fresh) {
        if (!old.isComposition() || !fresh.isComposition()) {
            return List.of();
        }
        Map<String, String> now = devices(fresh);
        Span place = fresh.component().span();
        List<Sentence> changes = new ArrayList<>();
        devices(old)
                .forEach(
                        (path, was) -> {
                            String is = now.getOrDefault(path, was);
                            if (!is.equals(was)) {
                                String format = "'%s' is %s in %s and %s in %s";
                                String before = old.title();
                                changes.add(
                                        Sentence.at(
                                                place,
                                                format,
                                                path,
                                                is,
                                                fresh.title(),
                                                was,
                                                before));
                            }
                        });
        return changes;
    }

    /** What stands at which path, in the order of the network. */
    private static Map<String, String> devices(Promise promise) {
        Map<String, String> devices = new LinkedHashMap<>();
        for (Network.Device each : promise.network().devices()) {
            devices.put(each.path(), Promise.title(each.component(), each.arguments()));
        }
        return devices;
    }

    private static boolean promisesNothing(Promise promise) {
        return !promise.isComposition() && promise.automata().isEmpty();
    }

    private static Promise promise(Component component, List<Value> given) {
        List<Value> arguments = Arguments.complete(component, given);
        return new Promise(component, arguments, automata(component)).withDevices();
    }

    /** A platform component promises its ports; what it does is not in the model. */
    private static List<Automaton> automata(Component component) {
        return component.platform() ? List.of() : Promise.of(component, List.of()).automata();
    }

    private Change.Witness forward(List<Value> arguments, Verdict verdict) {
        return new Change.Witness(fresh(arguments), fresh(arguments) + mark, verdict);
    }

    private Change.Witness backward(List<Value> arguments, Verdict verdict) {
        return new Change.Witness(fresh(arguments) + mark, fresh(arguments), verdict);
    }

    private String fresh(List<Value> arguments) {
        return Promise.title(fresh, arguments);
    }

    /** Who instantiates the old one can instantiate the new one with the same words. */
    private Optional<Sentence> parameterProblem() {
        List<Parameter> before = old.parameters();
        List<Parameter> after = fresh.parameters();
        boolean fits = before.size() <= after.size();
        for (int i = 0; fits && i < after.size(); i++) {
            boolean mayBeLeftOut = i >= before.size() || before.get(i).initial().isPresent();
            fits =
                    (i >= before.size() || before.get(i).type().equals(after.get(i).type()))
                            && (!mayBeLeftOut || after.get(i).initial().isPresent());
        }
        if (fits) {
            return Optional.empty();
        }
        String name = fresh.qualifiedName();
        String former = old.qualifiedName() + mark;
        return Optional.of(
                Sentence.at(
                        fresh.span(),
                        "%s takes %s; %s takes %s",
                        name,
                        signature(after),
                        former,
                        signature(before)));
    }

    private static String signature(List<Parameter> parameters) {
        return parameters.isEmpty()
                ? "no arguments"
                : parameters.stream()
                        .map(VersionComparison::signature)
                        .collect(Collectors.joining(", ", "(", ")"));
    }

    private static String signature(Parameter parameter) {
        String optional = parameter.initial().isPresent() ? "?" : "";
        return parameter.type().name() + " " + parameter.name() + optional;
    }
}
