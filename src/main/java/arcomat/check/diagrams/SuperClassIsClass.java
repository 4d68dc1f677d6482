package arcomat.check.diagrams;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.ClassDiagram;
import arcomat.tree.TypeReference;

/** ARC0606: what a class extends is a class, neither an enum nor a built-in type. */
public final class SuperClassIsClass implements Check.OnClassDiagram {

    @Override
    public Law law() {
        return Law.error("ARC0606");
    }

    @Override
    public void check(DiagramSymbol diagram, Context context, Findings findings) {
        for (ClassDiagram.TypeDefinition type : diagram.node().types()) {
            if (type instanceof ClassDiagram.ClassDefinition definition) {
                definition
                        .superClass()
                        .ifPresent(above -> check(definition, above, context, findings));
            }
        }
    }

    private static void check(
            ClassDiagram.ClassDefinition definition,
            TypeReference above,
            Context context,
            Findings findings) {
        context.resolve(above)
                .found()
                .filter(type -> !(type instanceof ClassSymbol) && !type.isErroneous())
                .ifPresent(type -> report(definition, above, type, findings));
    }

    private static void report(
            ClassDiagram.ClassDefinition definition,
            TypeReference above,
            TypeSymbol type,
            Findings findings) {
        findings.report(
                above,
                "class '"
                        + definition.name()
                        + "' cannot extend '"
                        + type.text()
                        + "', which is no class; make it an attribute");
    }
}
