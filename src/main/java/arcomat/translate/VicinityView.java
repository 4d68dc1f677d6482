package arcomat.translate;

import arcomat.guest.Vicinity;
import arcomat.guest.Vicinity.Kind;
import arcomat.guest.Vicinity.Value;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.RangeType;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.signatures.Signature;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What a language sees of the component around a behaviour: its signature, and nothing of its body.
 */
public final class VicinityView {
    private VicinityView() {}

    /** The view of a component. */
    public static Vicinity of(Signature component) {
        Map<String, Value> values = new LinkedHashMap<>();
        for (PortSymbol port : component.ports()) {
            Kind kind = port.isInput() ? Kind.INPUT : Kind.OUTPUT;
            values.putIfAbsent(
                    port.name(),
                    new Value(
                            kind, port.name(), type(port.type()), port.isTotal(), port.nameSpan()));
        }
        for (VariableSymbol each : component.variables()) {
            Vicinity.Type type = type(each.type());
            values.putIfAbsent(
                    each.name(),
                    new Value(Kind.VARIABLE, each.name(), type, false, each.nameSpan()));
        }
        for (ParameterSymbol each : component.parameters()) {
            Vicinity.Type type = type(each.type());
            values.putIfAbsent(
                    each.name(),
                    new Value(Kind.PARAMETER, each.name(), type, false, each.nameSpan()));
        }
        return new Vicinity(component.name(), List.copyOf(values.values()));
    }

    private static Vicinity.Type type(TypeSymbol type) {
        String name = type.text();
        if (type.isBoolean()) {
            return new Vicinity.Type.Choice(name, List.of("true", "false"));
        }
        if (type instanceof EnumSymbol symbol) {
            return new Vicinity.Type.Choice(name, symbol.constants().stream().distinct().toList());
        }
        return whole(type);
    }

    private static Vicinity.Type whole(TypeSymbol type) {
        String name = type.text();
        if (type.base() == BuiltinType.CHARACTER) {
            return new Vicinity.Type.Other(name);
        }
        if (type instanceof RangeType range && range.low() <= range.high()) {
            return new Vicinity.Type.Whole(name, range.low(), range.high());
        }
        // A range whose ends are reversed is told as such.
        return type instanceof BuiltinType builtin && builtin.isWhole()
                ? new Vicinity.Type.Whole(name, builtin.low(), builtin.high())
                : new Vicinity.Type.Other(name);
    }
}
