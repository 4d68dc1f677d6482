package arcomat.editor.answer.shape;

import arcomat.editor.desk.View;
import arcomat.editor.foreign.GuestText;
import arcomat.editor.name.Mentions;
import arcomat.editor.text.Positions;
import arcomat.source.Span;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.symbols.occurrences.Occurrence.Role;
import arcomat.symbols.occurrences.Referent;

import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.SemanticTokenModifiers;
import org.eclipse.lsp4j.SemanticTokenTypes;
import org.eclipse.lsp4j.SemanticTokens;
import org.eclipse.lsp4j.SemanticTokensLegend;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * What each name of a file is, for its colour. Words of the language have none of these: a grammar
 * for colours knows them, and the names among them that only look like keywords are these. Words of
 * guests' languages are among them, since no grammar knows those.
 */
public final class NameColours {
    private static final List<String> TYPES =
            List.of(
                    SemanticTokenTypes.Namespace,
                    SemanticTokenTypes.Class,
                    SemanticTokenTypes.Enum,
                    SemanticTokenTypes.Struct,
                    SemanticTokenTypes.Type,
                    SemanticTokenTypes.TypeParameter,
                    SemanticTokenTypes.EnumMember,
                    SemanticTokenTypes.Property,
                    SemanticTokenTypes.Variable,
                    SemanticTokenTypes.Parameter,
                    SemanticTokenTypes.Label,
                    SemanticTokenTypes.Function,
                    SemanticTokenTypes.Method,
                    SemanticTokenTypes.Keyword);

    private static final List<String> MODIFIERS =
            List.of(
                    SemanticTokenModifiers.Declaration,
                    SemanticTokenModifiers.Modification,
                    SemanticTokenModifiers.Readonly,
                    SemanticTokenModifiers.DefaultLibrary);

    /** Which number stands for what. */
    public static final SemanticTokensLegend LEGEND = new SemanticTokensLegend(TYPES, MODIFIERS);

    private NameColours() {}

    /**
     * @param modifiers a bit for each
     */
    private record Coloured(Span place, String type, int modifiers) {}

    public static SemanticTokens of(View view) {
        List<Integer> data = new ArrayList<>();
        Position last = new Position(0, 0);
        for (Coloured each : all(view)) {
            Position place = Positions.position(view.file(), each.place().start());
            int lines = place.getLine() - last.getLine();
            data.add(lines);
            data.add(place.getCharacter() - (lines == 0 ? last.getCharacter() : 0));
            data.add(each.place().end() - each.place().start());
            data.add(TYPES.indexOf(each.type()));
            data.add(each.modifiers());
            last = place;
        }
        return new SemanticTokens(data);
    }

    /** In the order of the text; what a guest's word names is a name. */
    private static Iterable<Coloured> all(View view) {
        SortedMap<Integer, Coloured> all = new TreeMap<>();
        Set<Span> fields = fields(view);
        for (Occurrence each : Mentions.in(view)) {
            String type = type(each.referent());
            all.put(
                    each.span().start(),
                    new Coloured(each.span(), type, modifiers(view, each, fields)));
        }
        List<Span> names = all.values().stream().map(Coloured::place).toList();
        for (GuestText text : GuestText.in(view)) {
            for (Span word : text.words()) {
                if (names.stream().noneMatch(name -> name.isAround(word))) {
                    all.put(word.start(), new Coloured(word, SemanticTokenTypes.Keyword, 0));
                }
            }
        }
        return all.values();
    }

    private static String type(Referent referent) {
        return switch (referent.kind()) {
            case PACKAGE, DIAGRAM -> SemanticTokenTypes.Namespace;
            case COMPONENT, SUITE -> SemanticTokenTypes.Class;
            case TYPE ->
                    ((Referent.Type) referent).symbol() instanceof EnumSymbol
                            ? SemanticTokenTypes.Enum
                            : SemanticTokenTypes.Struct;
            case BUILTIN -> SemanticTokenTypes.Type;
            case TYPE_PARAMETER -> SemanticTokenTypes.TypeParameter;
            case CONSTANT -> SemanticTokenTypes.EnumMember;
            case ATTRIBUTE, PORT -> SemanticTokenTypes.Property;
            case PART, VARIABLE, BOUND -> SemanticTokenTypes.Variable;
            case PARAMETER, FEATURE -> SemanticTokenTypes.Parameter;
            case STATE -> SemanticTokenTypes.Label;
            case BEHAVIOUR, INVARIANT -> SemanticTokenTypes.Function;
            case TEST -> SemanticTokenTypes.Method;
        };
    }

    private static int modifiers(View view, Occurrence occurrence, Set<Span> fields) {
        Referent referent = occurrence.referent();
        return bit(SemanticTokenModifiers.Declaration, occurrence.isDeclaration())
                | bit(SemanticTokenModifiers.Modification, occurrence.role() == Role.WRITES)
                | bit(SemanticTokenModifiers.Readonly, isConstant(referent, fields))
                | bit(SemanticTokenModifiers.DefaultLibrary, isOfTheTool(view, referent));
    }

    private static int bit(String modifier, boolean isSet) {
        return isSet ? 1 << MODIFIERS.indexOf(modifier) : 0;
    }

    /** Where the variables of components stand that automata of this file write. */
    private static Set<Span> fields(View view) {
        return view.models().workspace().components().stream()
                .filter(each -> each.unit().file().path().equals(view.file().path()))
                .flatMap(each -> each.fields().stream())
                .map(VariableSymbol::nameSpan)
                .collect(Collectors.toSet());
    }

    private static boolean isConstant(Referent referent, Set<Span> fields) {
        return switch (referent.kind()) {
            case CONSTANT, PARAMETER, FEATURE, PART, BOUND -> true;
            case VARIABLE -> isConstant(((Referent.Variable) referent.one()).symbol(), fields);
            default -> false;
        };
    }

    private static boolean isConstant(VariableSymbol variable, Set<Span> fields) {
        return variable.kind() == VariableSymbol.Kind.COMPONENT
                && !fields.contains(variable.nameSpan());
    }

    private static boolean isOfTheTool(View view, Referent referent) {
        return referent.kind() == Referent.Kind.BUILTIN
                || referent.declaration()
                        .filter(span -> view.models().isLibrary(span.file().path()))
                        .isPresent();
    }
}
