package arcomat.syntax.build;

import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.HashMap;
import java.util.Map;

/**
 * The builders for one file; they call each other. Trees of large models live long, so what is
 * equal is kept once: the texts of names and literals, and the spans of nodes around a sole child.
 */
final class Builders {
    final SourceFile file;
    private final Map<String, String> texts = new HashMap<>();
    private Span latest;
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
        this.latest = file.span(0, 0);
    }

    Span span(int start, int end) {
        if (latest.start() != start || latest.end() != end) {
            latest = file.span(start, end);
        }
        return latest;
    }

    String text(Span span) {
        String text = span.text();
        String known = texts.putIfAbsent(text, text);
        return known == null ? text : known;
    }
}
