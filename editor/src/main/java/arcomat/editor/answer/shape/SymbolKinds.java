package arcomat.editor.answer.shape;

import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.occurrences.Referent;

import org.eclipse.lsp4j.SymbolKind;

/** Which of the protocol's kinds, made for programs, is the nearest: it decides on the picture. */
public final class SymbolKinds {
    private SymbolKinds() {}

    public static SymbolKind of(Referent referent) {
        return switch (referent.kind()) {
            case PACKAGE -> SymbolKind.Package;
            case DIAGRAM -> SymbolKind.Namespace;
            case COMPONENT -> SymbolKind.Class;
            case TYPE -> type((Referent.Type) referent);
            case BUILTIN -> SymbolKind.Struct;
            case TYPE_PARAMETER -> SymbolKind.TypeParameter;
            case CONSTANT, STATE -> SymbolKind.EnumMember;
            case ATTRIBUTE -> SymbolKind.Field;
            case PORT -> SymbolKind.Interface;
            case PART -> SymbolKind.Object;
            case VARIABLE -> SymbolKind.Variable;
            case PARAMETER, BOUND -> SymbolKind.Constant;
            case BEHAVIOUR -> SymbolKind.Enum;
            case FEATURE, INVARIANT -> SymbolKind.Boolean;
            case SUITE -> SymbolKind.Module;
            case TEST -> SymbolKind.Method;
        };
    }

    private static SymbolKind type(Referent.Type type) {
        return type.symbol() instanceof EnumSymbol ? SymbolKind.Enum : SymbolKind.Struct;
    }
}
