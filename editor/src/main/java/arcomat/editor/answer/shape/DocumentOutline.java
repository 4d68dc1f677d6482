package arcomat.editor.answer.shape;

import arcomat.editor.desk.View;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.occurrences.Referent;
import arcomat.tree.Unit;

import org.eclipse.lsp4j.DocumentSymbol;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** What a file declares, nested as it is written; of a file with errors, what can be read. */
public final class DocumentOutline {
    private DocumentOutline() {}

    public static List<DocumentSymbol> of(View view) {
        return view.parsed().readable().stream()
                .flatMap(unit -> entries(view.models().workspace(), unit))
                .map(OutlineEntry::symbol)
                .toList();
    }

    private static Stream<OutlineEntry> entries(Workspace workspace, Unit unit) {
        return Stream.of(
                        workspace.topLevelComponents().stream()
                                .filter(each -> each.unit() == unit)
                                .map(ComponentOutline::of),
                        workspace.bareAutomata().stream()
                                .filter(each -> each.unit() == unit)
                                .map(ComponentOutline::automaton),
                        workspace.diagrams().stream()
                                .filter(each -> each.unit() == unit)
                                .map(DocumentOutline::diagram),
                        workspace.testSuites().stream()
                                .filter(each -> each.unit() == unit)
                                .map(DocumentOutline::suite))
                .flatMap(each -> each);
    }

    private static OutlineEntry diagram(DiagramSymbol diagram) {
        return OutlineEntry.of(
                Referent.diagramOf(diagram.unit(), diagram.node()),
                diagram.node().span(),
                diagram.types().stream().map(DocumentOutline::type));
    }

    private static OutlineEntry type(DefinedType type) {
        return OutlineEntry.of(
                new Referent.Type(type),
                type.node().span(),
                type instanceof EnumSymbol constants ? constants(constants) : attributes(type));
    }

    private static Stream<OutlineEntry> constants(EnumSymbol type) {
        return IntStream.range(0, type.constants().size())
                .mapToObj(i -> OutlineEntry.of(new Referent.Constant(type, i)));
    }

    private static Stream<OutlineEntry> attributes(DefinedType type) {
        return type instanceof ClassSymbol symbol ? attributes(symbol) : Stream.empty();
    }

    private static Stream<OutlineEntry> attributes(ClassSymbol type) {
        return type.attributes().stream()
                .filter(each -> each.owner() == type)
                .map(
                        each ->
                                OutlineEntry.of(
                                        new Referent.Attribute(each),
                                        each.node().span(),
                                        Stream.empty()));
    }

    private static OutlineEntry suite(TestSuiteSymbol suite) {
        return OutlineEntry.of(
                new Referent.Suite(suite),
                suite.node().span(),
                suite.tests().stream()
                        .map(
                                test ->
                                        OutlineEntry.of(
                                                new Referent.Test(test),
                                                test.node().span(),
                                                Stream.empty())));
    }
}
