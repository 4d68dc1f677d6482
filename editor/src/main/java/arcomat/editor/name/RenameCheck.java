package arcomat.editor.name;

import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.symbols.occurrences.Referent;
import arcomat.tree.Element;

import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Whether models mean the same after a renaming: every name stands for what it stood for, the same
 * ports are connected, and nothing new is wrong. Instead of a rule for each way in which a name can
 * come in the way of another one, the models are read again as they would be (Schäfer, Ekman, de
 * Moor, <i>Sound and extensible renaming for Java</i>, OOPSLA 2008).
 */
final class RenameCheck {
    private final RenamePlan plan;
    private final OpenModels before;
    private final OpenModels after;

    /**
     * @param before checked
     * @param after checked
     */
    private RenameCheck(RenamePlan plan, OpenModels before, OpenModels after) {
        this.plan = plan;
        this.before = before;
        this.after = after;
    }

    /** The first reason against it, if there is one. */
    static Optional<String> obstacle(RenamePlan plan, OpenModels before, OpenModels after) {
        RenameCheck check = new RenameCheck(plan, before, after);
        return check.mistake().or(check::otherMeaning).or(check::otherConnections);
    }

    // ---- what would be wrong --------------------------------------------------------------

    private record Mistake(String path, int start, String code) {}

    private Optional<String> mistake() {
        Set<Mistake> known = new HashSet<>();
        for (String path : before.paths()) {
            TextShift shift = plan.shift(path);
            errors(before, path)
                    .forEach(
                            each ->
                                    known.add(
                                            new Mistake(
                                                    plan.path(path),
                                                    shift.offset(each.span().start()),
                                                    each.code())));
        }
        return Stream.concat(declaring(), after.paths().stream())
                .flatMap(path -> errors(after, path).stream())
                .filter(each -> !known.contains(mistake(each)))
                .findFirst()
                .map(each -> "%s: %s".formatted(each.span(), each.message()));
    }

    /** What is said where a name is declared tells more than what follows from it. */
    private Stream<String> declaring() {
        return plan.names().keySet().stream()
                .map(each -> plan.path(each.declaration().orElseThrow().file().path()));
    }

    private static List<Diagnostic> errors(OpenModels models, String path) {
        return models.findings(path).stream().filter(Diagnostic::isError).toList();
    }

    private static Mistake mistake(Diagnostic finding) {
        Span span = finding.span();
        return new Mistake(span.file().path(), span.start(), finding.code());
    }

    // ---- what would mean something else ---------------------------------------------------

    /** What something is, told by where it is declared; the same before and after. */
    private record Anchor(Referent.Kind kind, String path, int start) {}

    private record Meaning(int start, Occurrence.Role role, Anchor anchor) {}

    private Optional<String> otherMeaning() {
        Set<String> paths = new TreeSet<>(RenamePlan.filesWith(before, plan.names().keySet()));
        plan.names().values().forEach(name -> Mentions.withWord(before, name).forEach(paths::add));
        // What the library means is not said by others; which of its files are needed is.
        paths.removeIf(before::isLibrary);
        return paths.stream().flatMap(path -> otherMeaning(path).stream()).findFirst();
    }

    private Optional<String> otherMeaning(String path) {
        Set<Integer> fresh = writtenIn(path);
        List<Meaning> now =
                Mentions.in(after, plan.path(path)).stream()
                        .filter(each -> !fresh.contains(each.span().start()))
                        .map(each -> meaning(each.span().start(), each, anchor(each.referent())))
                        .toList();
        Set<Meaning> then = new HashSet<>(now);
        TextShift shift = plan.shift(path);
        List<Occurrence> known = Mentions.in(before, path);
        Optional<Occurrence> other =
                known.stream()
                        .filter(
                                each ->
                                        !then.contains(
                                                meaning(
                                                        shift.offset(each.span().start()),
                                                        each,
                                                        moved(each.referent()))))
                        .findFirst();
        if (other.isPresent()) {
            return Optional.of(
                    "at %s '%s' would stand for something else"
                            .formatted(
                                    other.get().span(),
                                    plan.names()
                                            .getOrDefault(
                                                    other.get().referent(),
                                                    other.get().span().text())));
        }
        return now.size() == known.size()
                ? Optional.empty()
                : Optional.of("in %s a name that is unknown would become known".formatted(path));
    }

    private static Meaning meaning(int start, Occurrence occurrence, Anchor anchor) {
        return new Meaning(start, occurrence.role(), anchor);
    }

    private Set<Integer> writtenIn(String path) {
        return plan.written().keySet().stream()
                .filter(each -> each.declaration().orElseThrow().file().path().equals(path))
                .map(this::writtenStart)
                .collect(Collectors.toSet());
    }

    /** Where the name is that is now written; a space is in front of it. */
    private int writtenStart(Referent referent) {
        var edit = Objects.requireNonNull(plan.written().get(referent));
        int behind = plan.shift(edit.span().file().path()).offset(edit.span().start());
        return behind - edit.text().length() + 1;
    }

    private static Anchor anchor(Referent referent) {
        return referent.declaration()
                .map(span -> new Anchor(referent.kind(), span.file().path(), span.start()))
                .orElseGet(() -> nowhere(referent));
    }

    /** Packages are their names, and so are types that are built in. */
    private static Anchor nowhere(Referent referent) {
        return new Anchor(referent.kind(), referent.toString(), 0);
    }

    private Anchor moved(Referent referent) {
        return referent.declaration()
                .map(
                        span ->
                                new Anchor(
                                        referent.kind(),
                                        plan.path(span.file().path()),
                                        plan.written().containsKey(referent)
                                                ? writtenStart(referent)
                                                : plan.shift(span.file().path())
                                                        .offset(span.start())))
                .orElseGet(() -> nowhere(referent));
    }

    // ---- what would be connected otherwise ------------------------------------------------

    private record Connection(Anchor from, Anchor out, Anchor to, Anchor in) {}

    /** Ports are connected by their names where a component says so. */
    private Optional<String> otherConnections() {
        List<ComponentSymbol> known = before.workspace().components();
        List<ComponentSymbol> now = after.workspace().components();
        for (ComponentSymbol whole : known) {
            if (isAutomatic(whole)) {
                Anchor place = moved(new Referent.Component(whole.signature()));
                Set<Connection> same =
                        now.stream()
                                .filter(
                                        each ->
                                                anchor(new Referent.Component(each.signature()))
                                                        .equals(place))
                                .flatMap(each -> connections(each, true))
                                .collect(Collectors.toSet());
                if (!connections(whole, false).collect(Collectors.toSet()).equals(same)) {
                    return Optional.of(
                            ("'%s' connects ports by their names ('autoconnect'), and would connect"
                                            + " others; write its connectors first")
                                    .formatted(whole.name()));
                }
            }
        }
        return Optional.empty();
    }

    private static boolean isAutomatic(ComponentSymbol whole) {
        return whole.lineage().stream()
                .anyMatch(each -> !each.node().elements(Element.Autoconnect.class).isEmpty());
    }

    private Stream<Connection> connections(ComponentSymbol whole, boolean isNow) {
        return whole.connectors().stream()
                .filter(each -> each.origin() == ConnectorSymbol.Origin.AUTOMATIC)
                .map(
                        each ->
                                new Connection(
                                        part(each.source(), isNow),
                                        port(each.source(), isNow),
                                        part(each.target(), isNow),
                                        port(each.target(), isNow)));
    }

    private Anchor part(ConnectorSymbol.End end, boolean isNow) {
        return end.instance()
                .map(part -> of(new Referent.Part(part), isNow))
                .orElse(new Anchor(Referent.Kind.COMPONENT, "", 0));
    }

    private Anchor port(ConnectorSymbol.End end, boolean isNow) {
        return of(new Referent.Port(end.port().orElseThrow()), isNow);
    }

    private Anchor of(Referent referent, boolean isNow) {
        return isNow ? anchor(referent) : moved(referent);
    }
}
