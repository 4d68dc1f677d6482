package arcomat.editor.answer.fact;

import arcomat.editor.answer.completion.WritingPlace;
import arcomat.editor.desk.View;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnitScope;
import arcomat.symbols.occurrences.Referent;
import arcomat.symbols.signatures.Signature;
import arcomat.syntax.Caret;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;

import org.eclipse.lsp4j.ParameterInformation;
import org.eclipse.lsp4j.SignatureHelp;
import org.eclipse.lsp4j.SignatureInformation;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Which parameters there are while arguments are being written: of a component for a part or for a
 * suite of tests, and the attributes of an object in a message.
 */
public final class ParameterHelp {
    private ParameterHelp() {}

    public static Optional<SignatureHelp> at(View view, int offset) {
        return Caret.at(view.file(), offset)
                .flatMap(
                        caret ->
                                OpenArguments.at(caret.statement())
                                        .flatMap(open -> help(view, caret, open)));
    }

    private static Optional<SignatureHelp> help(View view, Caret caret, OpenArguments open) {
        WritingPlace place = WritingPlace.of(view, caret);
        QualifiedName name = written(open.name(), caret.typed());
        return parameters(place, name, caret.statement())
                .or(() -> attributes(place, name))
                .map(signature -> new SignatureHelp(List.of(signature), 0, open.position()));
    }

    private static QualifiedName written(List<String> words, Span place) {
        return new QualifiedName(place, words.stream().map(word -> new Name(place, word)).toList());
    }

    private static Optional<SignatureInformation> parameters(
            WritingPlace place, QualifiedName name, List<String> statement) {
        if (!statement.contains("component") && !statement.contains("testsuite")) {
            return Optional.empty();
        }
        return component(place, name)
                .map(
                        found ->
                                information(
                                        found.name(),
                                        found.parameters().stream()
                                                .map(Referent.Parameter::new)
                                                .map(new DeclarationLine()::parameter)
                                                .toList()));
    }

    /**
     * As the component around the place sees it. In front of a body that is still to be written
     * nothing of a file can be read: then the only one of that name is meant.
     */
    private static Optional<Signature> component(WritingPlace place, QualifiedName name) {
        return place.component()
                .map(around -> around.signature().resolveComponent(name).found())
                .orElseGet(() -> onlyOne(place, name.text()));
    }

    private static Optional<Signature> onlyOne(WritingPlace place, String name) {
        List<ComponentSymbol> named =
                place.workspace().topLevelComponents().stream()
                        .filter(
                                each ->
                                        each.name().equals(name)
                                                || each.qualifiedName().equals(name))
                        .toList();
        return named.size() == 1 ? Optional.of(named.get(0).signature()) : Optional.empty();
    }

    private static Optional<UnitScope> scope(WritingPlace place) {
        return place.unit().map(unit -> place.workspace().scope(unit));
    }

    private static Optional<SignatureInformation> attributes(
            WritingPlace place, QualifiedName name) {
        return scope(place)
                .map(scope -> scope.type(name))
                .flatMap(Resolution::found)
                .flatMap(ParameterHelp::attributes);
    }

    private static Optional<SignatureInformation> attributes(TypeSymbol type) {
        return type instanceof ClassSymbol found
                ? Optional.of(
                        information(
                                found.text(),
                                found.attributes().stream()
                                        .map(Referent.Attribute::new)
                                        .map(new DeclarationLine()::attribute)
                                        .toList()))
                : Optional.empty();
    }

    private static SignatureInformation information(String name, List<String> parameters) {
        SignatureInformation information =
                new SignatureInformation(
                        parameters.stream().collect(Collectors.joining(", ", name + "(", ")")));
        information.setParameters(parameters.stream().map(ParameterInformation::new).toList());
        return information;
    }
}
