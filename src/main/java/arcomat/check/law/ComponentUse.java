package arcomat.check.law;

import arcomat.symbols.signatures.ComponentReference;
import arcomat.tree.QualifiedName;
import arcomat.tree.TypeArgument;

import java.util.List;

/**
 * A place where a component is named.
 *
 * @param name as written; of an inner component with an instance name, that name
 * @param arguments for its type parameters, as written
 */
public record ComponentUse(
        ComponentReference reference, QualifiedName name, List<TypeArgument> arguments) {}
