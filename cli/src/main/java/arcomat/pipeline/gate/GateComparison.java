package arcomat.pipeline.gate;

import arcomat.analysis.evolution.Change;
import arcomat.analysis.evolution.ChangeImpact;
import arcomat.analysis.evolution.Gate;
import arcomat.analysis.evolution.VersionComparison;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.pipeline.Progress;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.analysis.InstanceArguments;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** The components of two versions of models, one by one: what became of what each promised. */
final class GateComparison {
    private final GateSide base;
    private final GateSide fresh;
    private final BreakReasons reasons;
    private final AnalysisLimits limits;
    private final Progress progress;
    private final ChangeImpact changed;
    private final List<Gate.Entry> entries = new ArrayList<>();

    /** Read when a component with parameters has to be compared. */
    private Optional<List<InstanceArguments>> arguments = Optional.empty();

    /**
     * @param reasons for promises that are not kept, of which those that are good are used up
     * @param limits of each single comparison
     */
    GateComparison(
            GateSide base,
            GateSide fresh,
            BreakReasons reasons,
            AnalysisLimits limits,
            Progress progress) {
        this.base = base;
        this.fresh = fresh;
        this.reasons = reasons;
        this.limits = limits;
        this.progress = progress;
        this.changed = ChangeImpact.between(base.model(), fresh.model());
    }

    /** Compares what is in a scope. */
    Gate in(GateScope scope) {
        Set<String> names = new TreeSet<>(base.components().keySet());
        names.addAll(fresh.components().keySet());
        for (String name : names) {
            Optional<GateSide.Declared> before = Optional.ofNullable(base.components().get(name));
            Optional<GateSide.Declared> after = Optional.ofNullable(fresh.components().get(name));
            if (after.isEmpty()) {
                if (base.isNamedByUser(before.get()) && scope.contains(before.get())) {
                    gone(name, before);
                }
            } else if (fresh.isNamedByUser(after.get())) {
                if (before.isEmpty()) {
                    Change change = base.mayTellOf(name) ? Change.UNREAD : Change.NEW;
                    add(name, change, before, after, Optional.empty());
                } else {
                    compare(name, before.get(), after.get());
                }
            }
        }
        return new Gate(GateCauses.of(entries, fresh.model(), changed));
    }

    /** A file that is left out may have it, or a reason why it is gone, perhaps an old one. */
    private void gone(String name, Optional<GateSide.Declared> before) {
        if (fresh.mayTellOf(name) || base.mayGiveReasons()) {
            add(name, Change.UNREAD, before, Optional.empty(), Optional.empty());
        } else {
            add(name, Change.GONE, before, Optional.empty(), reasons.gone(name));
        }
    }

    private void add(
            String name,
            Change change,
            Optional<GateSide.Declared> before,
            Optional<GateSide.Declared> after,
            Optional<String> excuse) {
        entries.add(
                new Gate.Entry(
                        name,
                        change,
                        before.map(GateSide.Declared::name),
                        after.map(GateSide.Declared::name),
                        excuse,
                        Optional.empty()));
    }

    /** What is generic is compared for the type arguments that it has on both sides. */
    private void compare(String name, GateSide.Declared before, GateSide.Declared after) {
        Set<String> common = new TreeSet<>(before.instantiations().keySet());
        common.retainAll(after.instantiations().keySet());
        if (common.isEmpty()) {
            add(name, before, after, uninstantiated(before, after));
        }
        for (String each : common) {
            Component old = Objects.requireNonNull(before.instantiations().get(each));
            Component now = Objects.requireNonNull(after.instantiations().get(each));
            add(each, before, after, change(old, now));
        }
    }

    private void add(
            String name, GateSide.Declared before, GateSide.Declared after, Change change) {
        Optional<String> excuse =
                change.relation().isDoubtful()
                        ? reasons.breaks(name.replaceFirst("<.*", ""), after)
                        : Optional.empty();
        add(name, change, Optional.of(before), Optional.of(after), excuse);
    }

    private static Change uninstantiated(GateSide.Declared before, GateSide.Declared after) {
        return before.span().text().equals(after.span().text())
                ? Change.UNCHANGED
                : Change.unknown(
                        "it is generic, and no part has it with the same type arguments in both"
                                + " models");
    }

    private Change change(Component old, Component now) {
        if (!changed.contains(now)) {
            return Change.UNCHANGED;
        }
        progress.step("comparing " + now.qualifiedName());
        Set<List<Value>> given = old.parameters().isEmpty() ? Set.of() : given(old);
        Change change =
                new VersionComparison(old, " (base)", now, () -> limits.each().budget())
                        .with(given);
        return mayBeGivenMore(old) && !change.relation().breaks() ? Change.UNREAD : change;
    }

    /** A file that is left out may have an instance, with arguments that nobody has seen. */
    private boolean mayBeGivenMore(Component component) {
        return !component.parameters().isEmpty() && !(base.isWhole() && fresh.isWhole());
    }

    /** What its instances give it, in the old models and in the new ones. */
    private Set<List<Value>> given(Component old) {
        if (arguments.isEmpty()) {
            arguments =
                    Optional.of(
                            List.of(
                                    InstanceArguments.in(base.model()),
                                    InstanceArguments.in(fresh.model())));
        }
        Set<List<Value>> given = new LinkedHashSet<>();
        for (InstanceArguments each : arguments.get()) {
            each.of(old).stream()
                    .filter(values -> values.size() == old.parameters().size())
                    .forEach(given::add);
        }
        return given;
    }
}
