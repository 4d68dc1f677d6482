package arcomat.syntax.build;

import arcomat.source.SourceFile;

/** The builders for one file; they call each other. */
final class Builders {
    final SourceFile file;
    final NameBuilder names = new NameBuilder(this);
    final QualifiedNameBuilder qualifiedNames = new QualifiedNameBuilder(this);
    final TypeBuilder types = new TypeBuilder(this);
    final TypeArgumentBuilder typeArguments = new TypeArgumentBuilder(this);
    final OperandBuilder operands = new OperandBuilder(this);
    final ExpressionBuilder expressions = new ExpressionBuilder(this);
    final VariableBuilder variables = new VariableBuilder(this);
    final StereotypeBuilder stereotypes = new StereotypeBuilder(this);
    final ValueBuilder values = new ValueBuilder(this);
    final BlockBuilder blocks = new BlockBuilder(this);
    final AutomatonBuilder automata = new AutomatonBuilder(this);
    final BehaviourBuilder behaviours = new BehaviourBuilder(this);
    final ComponentBuilder components = new ComponentBuilder(this);
    final ElementBuilder elements = new ElementBuilder(this);
    final ClassDiagramBuilder classDiagrams = new ClassDiagramBuilder(this);
    final StreamBuilder streams = new StreamBuilder(this);
    final TestSuiteBuilder testSuites = new TestSuiteBuilder(this);

    Builders(SourceFile file) {
        this.file = file;
    }
}
