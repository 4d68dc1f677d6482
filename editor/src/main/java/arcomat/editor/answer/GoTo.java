package arcomat.editor.answer;

import arcomat.editor.desk.View;
import arcomat.editor.name.Mentions;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.symbols.occurrences.Referent;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.symbols.signatures.Signature;

import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.Position;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** From a name to what it stands for, to the type of that, or to what makes it real. */
public final class GoTo {
    private GoTo() {}

    public static List<Location> definition(View view, Position position) {
        return locations(view, named(view, position).flatMap(Referent::declaration).stream());
    }

    /** Of a port or another value, its type; of a part, its component. */
    public static List<Location> typeDefinition(View view, Position position) {
        return locations(
                view,
                named(view, position)
                        .flatMap(Referent::typeReferent)
                        .flatMap(Referent::declaration)
                        .stream());
    }

    /** Of a component, those that refine or extend it; of a class, those that extend it. */
    public static List<Location> implementation(View view, Position position) {
        return locations(view, named(view, position).stream().flatMap(each -> heirs(view, each)));
    }

    private static Optional<Referent> named(View view, Position position) {
        return Mentions.at(view, view.offset(position)).map(Occurrence::referent);
    }

    private static List<Location> locations(View view, Stream<Span> spans) {
        return spans.map(view::location).toList();
    }

    private static Stream<Span> heirs(View view, Referent referent) {
        if (referent instanceof Referent.Component component) {
            return components(view, component.signature()).stream().map(Signature::nameSpan);
        }
        return referent instanceof Referent.Type type
                ? classes(view, type.symbol()).map(DefinedType::nameSpan)
                : Stream.empty();
    }

    /** Over any number of steps, the nearest first. */
    private static Set<Signature> components(View view, Signature start) {
        Set<Signature> found = new LinkedHashSet<>();
        List<Signature> last = List.of(start);
        while (!last.isEmpty()) {
            List<Signature> above = last;
            last =
                    view.models().workspace().components().stream()
                            .map(ComponentSymbol::signature)
                            .filter(each -> isBelow(each, above) && !each.equals(start))
                            .filter(found::add)
                            .toList();
        }
        return found;
    }

    private static boolean isBelow(Signature heir, List<Signature> above) {
        return heir.superComponent()
                        .flatMap(ComponentReference::component)
                        .filter(above::contains)
                        .isPresent()
                || heir.refines().stream()
                        .map(Signature.Refinement::resolution)
                        .map(Resolution::found)
                        .anyMatch(refined -> refined.filter(above::contains).isPresent());
    }

    private static Stream<DefinedType> classes(View view, DefinedType above) {
        return view.models().workspace().diagrams().stream()
                .map(DiagramSymbol::types)
                .flatMap(List::stream)
                .filter(
                        type ->
                                type != above
                                        && type instanceof ClassSymbol symbol
                                        && symbol.lineage().contains(above));
    }
}
