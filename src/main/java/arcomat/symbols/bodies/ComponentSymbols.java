package arcomat.symbols.bodies;

import arcomat.symbols.signatures.Signature;

import java.util.IdentityHashMap;
import java.util.Map;

/** All components with their bodies, by signature. Filled once. */
public final class ComponentSymbols {
    private final Map<Signature, ComponentSymbol> bySignature = new IdentityHashMap<>();

    /** Makes the symbol of a component and those of the components inside it. */
    public ComponentSymbol add(Signature signature) {
        ComponentSymbol symbol = new ComponentSymbol(signature, this);
        bySignature.put(signature, symbol);
        signature.innerComponents().forEach(this::add);
        return symbol;
    }

    public ComponentSymbol of(Signature signature) {
        return bySignature.get(signature);
    }
}
