package arcomat.syntax.build;

/** The builders of what occurs in definitions of every kind. */
final class Phrases {
    final SharedTexts texts;
    final NameBuilder names;
    final QualifiedNameBuilder qualifiedNames;
    final ExpressionBuilder expressions;
    final TypeBuilder types;
    final StereotypeBuilder stereotypes;
    final VariableBuilder variables;
    final ValueBuilder values;

    Phrases(SharedTexts texts) {
        this.texts = texts;
        this.names = new NameBuilder(texts);
        this.qualifiedNames = new QualifiedNameBuilder(texts, names);
        this.expressions = new ExpressionBuilder(texts, names, qualifiedNames);
        this.types = expressions.types;
        this.stereotypes = new StereotypeBuilder(texts, names);
        this.variables = new VariableBuilder(texts, names, expressions);
        this.values = new ValueBuilder(texts, expressions);
    }
}
