package arcomat.editor.answer.completion;

import arcomat.editor.answer.completion.Proposal.Kind;
import arcomat.source.Fix.TextEdit;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.UnitScope;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Components and types, those that an import would bring included.
 *
 * @param place what is around the place
 */
record KnownDefinitions(WritingPlace place) {
    private static final List<BuiltinType> USUAL =
            List.of(
                    BuiltinType.BOOLEAN,
                    BuiltinType.INTEGER,
                    BuiltinType.DOUBLE,
                    BuiltinType.STRING);

    List<Proposal> components() {
        Optional<ComponentSymbol> around = place.component();
        return place.workspace().topLevelComponents().stream()
                .filter(each -> around.filter(own -> own == each).isEmpty())
                .map(each -> named(each.name(), Kind.COMPONENT, each.qualifiedName(), isSeen(each)))
                .toList();
    }

    private boolean isSeen(ComponentSymbol component) {
        return scope().flatMap(scope -> scope.component(written(component.name())).found())
                .filter(found -> found == component.signature().declaration())
                .isPresent();
    }

    List<Proposal> types() {
        Stream<Proposal> builtin =
                USUAL.stream().map(type -> Proposal.of(type.text(), Kind.BUILTIN_TYPE, "type"));
        Stream<Proposal> defined =
                place.workspace().diagrams().stream()
                        .flatMap(diagram -> diagram.types().stream())
                        .map(
                                type ->
                                        named(
                                                type.text(),
                                                Kind.TYPE,
                                                type.qualifiedName(),
                                                isSeen(type)));
        return Stream.concat(builtin, defined).toList();
    }

    private boolean isSeen(DefinedType type) {
        return scope().flatMap(scope -> scope.type(written(type.text())).found())
                .filter(found -> found == type)
                .isPresent();
    }

    private Optional<UnitScope> scope() {
        return place.unit().map(unit -> place.workspace().scope(unit));
    }

    private QualifiedName written(String name) {
        Span typed = place.caret().typed();
        return new QualifiedName(typed, List.of(new Name(typed, name)));
    }

    private Proposal named(String name, Kind kind, String qualifiedName, boolean seen) {
        List<TextEdit> needed = new ArrayList<>();
        if (!seen && !qualifiedName.equals(name)) {
            place.unit().ifPresent(unit -> needed.add(importing(qualifiedName, unit)));
        }
        return new Proposal(name, kind, qualifiedName, needed);
    }

    /** Behind the other imports; where there is none, behind the package with a line between. */
    private static TextEdit importing(String qualifiedName, Unit unit) {
        String text = "import " + qualifiedName + ";";
        List<Unit.Import> imports = unit.imports();
        if (!imports.isEmpty()) {
            int end = imports.get(imports.size() - 1).span().end();
            return new TextEdit(unit.file().span(end, end), "\n" + text);
        }
        return unit.packageName()
                .map(
                        name -> {
                            int end = unit.file().text().indexOf(';', name.span().end()) + 1;
                            return new TextEdit(unit.file().span(end, end), "\n\n" + text);
                        })
                .orElseGet(() -> new TextEdit(unit.file().span(0, 0), text + "\n\n"));
    }
}
