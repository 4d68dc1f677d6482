package arcomat.symbols.signatures;

import arcomat.symbols.names.ComponentDeclaration;

import java.util.IdentityHashMap;
import java.util.Map;

/** The signatures of all components that can be named, by declaration. Filled once. */
public final class Signatures {
    private final Map<ComponentDeclaration, Signature> byDeclaration = new IdentityHashMap<>();

    /** Makes the signature of a component and those of the components inside it. */
    public void add(ComponentDeclaration declaration) {
        byDeclaration.put(declaration, new Signature(declaration, this));
        declaration.innerComponents().forEach(this::add);
    }

    public Signature of(ComponentDeclaration declaration) {
        return byDeclaration.get(declaration);
    }
}
