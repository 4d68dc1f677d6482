package arcomat.pipeline.gate;

import arcomat.analysis.evolution.Change;
import arcomat.analysis.evolution.ChangeImpact;
import arcomat.analysis.evolution.Gate;
import arcomat.analysis.evolution.VersionComparison;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.pipeline.analysis.InstanceArguments;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** Compares every component of a model with what it was in another model root. */
public final class GateStep {
    private final GateRequest request;
    private final GateSide base;
    private final GateSide fresh;
    private final Progress progress;
    private final ChangeImpact changed;
    private final Excuses excuses;
    private final List<Gate.Entry> entries = new ArrayList<>();

    /** Read when a component with parameters has to be compared. */
    private Optional<List<InstanceArguments>> arguments = Optional.empty();

    private GateStep(GateRequest request, GateSide base, GateSide fresh, Progress progress) {
        this.request = request;
        this.base = base;
        this.fresh = fresh;
        this.progress = progress;
        this.changed = ChangeImpact.between(base.model(), fresh.model());
        this.excuses = new Excuses(base, fresh);
    }

    public static GateResult run(GateRequest request, PathNames names, Progress progress)
            throws WrongUse {
        refuseBaseInside(request, names);
        CheckedModels old = CheckedModels.checkWithoutTests(request.base(), names, progress);
        CheckedModels now = CheckedModels.checkWithoutTests(request.paths(), names, progress);
        if (old.hasErrors() || now.hasErrors()) {
            return new GateResult(
                    old.result(), now.result(), Optional.empty(), List.of(), List.of());
        }
        GateScope scope = new GateScope(old, now, request.paths(), names);
        GateSide base = GateSide.of(old, progress);
        GateSide fresh = GateSide.of(now, progress);
        GateStep step = new GateStep(request, base, fresh, progress);
        Gate gate = step.compare(scope);
        GateFindings found = GateFindings.of(gate, base, fresh, step.excuses);
        return new GateResult(
                old.result(), now.result(), Optional.of(gate), found.findings(), found.meant());
    }

    /** The base would be searched as a part of the new models. */
    private static void refuseBaseInside(GateRequest request, PathNames names) throws WrongUse {
        for (String base : request.base()) {
            for (String path : request.paths()) {
                Path old = PathNames.real(names.resolve(base));
                Path now = PathNames.real(names.resolve(path));
                if (old.startsWith(now) && isSearched(now.relativize(old))) {
                    throw new WrongUse(
                            "the base '"
                                    + base
                                    + "' is inside '"
                                    + path
                                    + "'; put the old models into a folder beside the new ones");
                }
            }
        }
    }

    private static boolean isSearched(Path inside) {
        for (Path folder : inside) {
            if (folder.toString().startsWith(".")) {
                return false;
            }
        }
        return true;
    }

    private Gate compare(GateScope scope) {
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
            add(name, Change.GONE, before, Optional.empty(), excuses.gone(name));
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
            Component old = before.instantiations().get(each);
            Component now = after.instantiations().get(each);
            add(each, before, after, change(old, now));
        }
    }

    private void add(
            String name, GateSide.Declared before, GateSide.Declared after, Change change) {
        Optional<String> excuse =
                change.relation().isDoubtful()
                        ? excuses.breaks(name.replaceFirst("<.*", ""), after)
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
                new VersionComparison(old, " (base)", now, () -> request.limits().each().budget())
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
