package arcomat.editor.answer.shape;

import arcomat.editor.desk.Desk;
import arcomat.editor.text.Positions;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.names.Names;
import arcomat.symbols.occurrences.Referent;
import arcomat.tree.Unit;

import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.WorkspaceSymbol;
import org.eclipse.lsp4j.jsonrpc.messages.Either;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * Looks for what other files can name, and for tests, in all that is on the desk.
 *
 * @param letters some letters of a name in their order, whatever their case; where a dot is among
 *     them, of the name with all that stands in front of it
 */
public record SymbolSearch(String letters) {
    /** An editor asks again after each letter, and nobody reads more. */
    private static final int MOST = 500;

    /**
     * What may be found.
     *
     * @param around what stands in front of its name; may be empty
     */
    private record Known(Referent referent, String around) {
        private Known(Referent referent, Unit unit) {
            this(referent, unit.packageText());
        }

        private Span place() {
            return referent.declaration().orElseThrow();
        }
    }

    /** The best first: names that begin with the letters, and of these the shortest. */
    public List<WorkspaceSymbol> on(Desk desk) {
        return desk.models().stream()
                .flatMap(models -> in(models).map(each -> symbol(each, desk, models)))
                .sorted(
                        Comparator.comparing((WorkspaceSymbol each) -> !begins(each.getName()))
                                .thenComparing(each -> each.getName().length())
                                .thenComparing(WorkspaceSymbol::getName))
                .limit(MOST)
                .toList();
    }

    private Stream<Known> in(OpenModels models) {
        return all(models.workspace())
                .filter(each -> !models.isLibrary(each.place().file().path()))
                .filter(this::fits);
    }

    private static Stream<Known> all(Workspace workspace) {
        Stream<Known> components =
                workspace.components().stream()
                        .map(
                                each ->
                                        new Known(
                                                new Referent.Component(each.signature()),
                                                Names.qualifier(each.qualifiedName())));
        Stream<Known> types =
                workspace.diagrams().stream()
                        .flatMap(diagram -> diagram.types().stream())
                        .map(
                                each ->
                                        new Known(
                                                new Referent.Type(each),
                                                Names.qualifier(each.qualifiedName())));
        Stream<Known> suites = workspace.testSuites().stream().flatMap(SymbolSearch::suite);
        return Stream.of(components, types, automata(workspace), suites).flatMap(each -> each);
    }

    private static Stream<Known> automata(Workspace workspace) {
        return workspace.bareAutomata().stream()
                .flatMap(
                        each ->
                                each.node().name().stream()
                                        .map(Referent.Behaviour::new)
                                        .map(named -> new Known(named, each.unit())));
    }

    private static Stream<Known> suite(TestSuiteSymbol suite) {
        String name = Names.join(suite.unit().packageText(), suite.name());
        return Stream.concat(
                Stream.of(new Known(new Referent.Suite(suite), suite.unit())),
                suite.tests().stream().map(test -> new Known(new Referent.Test(test), name)));
    }

    private boolean fits(Known known) {
        String name = known.referent().name();
        String searched = letters.contains(".") ? Names.join(known.around(), name) : name;
        int at = 0;
        for (char letter : lower(letters).toCharArray()) {
            at = lower(searched).indexOf(letter, at) + 1;
            if (at == 0) {
                return false;
            }
        }
        return true;
    }

    private boolean begins(String name) {
        return lower(name).startsWith(lower(letters));
    }

    private static String lower(String text) {
        return text.toLowerCase(Locale.ROOT);
    }

    private static WorkspaceSymbol symbol(Known known, Desk desk, OpenModels models) {
        Span place = known.place();
        String address = desk.place(models, place.file().path()).toUri().toString();
        return new WorkspaceSymbol(
                known.referent().name(),
                SymbolKinds.of(known.referent()),
                Either.forLeft(new Location(address, Positions.range(place))),
                known.around());
    }
}
