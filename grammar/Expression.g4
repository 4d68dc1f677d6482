/*
 * Types and expressions: guards in the manner of OCL/P, right-hand sides, arguments, ranges.
 */
grammar Expression;

import Lexical;

expressionUnit
    : expression EOF
    ;

// From the tightest to the loosest operator.
expression
    : primary suffix*                                                       # operandExpression
    | operator = ('!' | '-' | '+' | '~') expression                         # unaryExpression
    | '(' primitiveType ')' expression                                      # primitiveCastExpression
    | '(' objectType ')' castOperand                                            # castExpression
    | left = expression operator = ('*' | '/' | '%') right = expression     # binaryExpression
    | left = expression operator = ('+' | '-') right = expression           # binaryExpression
    | left = expression operator = ('<' | '<=' | '>' | '>=') right = expression # binaryExpression
    | expression 'instanceof' instanceType                                  # instanceOfExpression
    | expression 'isin' '{' (expression (',' expression)*)? '}'             # membershipExpression
    // Two alternatives: one with a choice inside would misparse "a == b && c".
    | expression operator = ('==' | '!=') '--'                              # absenceExpression
    | left = expression operator = ('==' | '!=') right = expression         # binaryExpression
    | left = expression operator = '&&' right = expression                  # binaryExpression
    | left = expression operator = '||' right = expression                  # binaryExpression
    | <assoc = right> left = expression operator = 'implies' right = expression # binaryExpression
    | left = expression operator = '<=>' right = expression                 # binaryExpression
    | <assoc = right> expression '?' expression ':' expression              # conditionalExpression
    | 'if' expression 'then' expression 'else' expression                   # ifExpression
    // Reach as far to the right as they can.
    | quantifier = ('forall' | 'exists') name 'in' domain ':' expression    # quantifiedExpression
    | 'let' name '=' expression 'in' expression                             # letExpression
    ;

// A name may be that of an array or of a type.
domain
    : kind = ID? '{' (member (',' member)*)? '}'                            # memberDomain
    | type                                                                  # namedDomain
    ;

member
    : low = expression ('..' high = expression)?
    ;

suffix
    : '.' name arguments?                                                   # accessSuffix
    | '[' expression ']'                                                    # indexSuffix
    ;

// Alternatives without labels, as of items and values in blocks: these three are most of a parse
// tree, and a labelled one is made twice.
primary
    : literal
    | name arguments?
    | '(' expression ')'
    | 'new' creator
    ;

// No sign in front: "(a) - b" is a subtraction.
castOperand
    : primary suffix*                                                       # plainOperand
    | operator = ('!' | '~') castOperand                                    # unaryOperand
    | '(' primitiveType ')' castOperand                                     # primitiveCastOperand
    | '(' objectType ')' castOperand                                            # typeCastOperand
    ;

arguments
    : '(' (expression (',' expression)*)? ')'
    ;

// For the parameters of a component, some by their names.
componentArguments
    : '(' (componentArgument (',' componentArgument)*)? ')'
    ;

componentArgument
    : (name '=')? expression
    ;

creator
    : name ('.' name)* typeArguments? (arguments | ('[' expression ']')+)
    | primitiveType ('[' expression ']')+
    ;

// No primitive type: a cast to one has a production of its own, and two would be ambiguous.
objectType
    : qualifiedName typeArguments?
    ;

instanceType
    : name ('.' name)*
    ;

type
    : (qualifiedName | primitiveType) typeArguments? typeSuffix?
    ;

// A type that cannot be mistaken for the beginning of another element.
plainType
    : (plainName | primitiveType) typeArguments? typeSuffix?
    ;

plainName
    : ID ('.' name)*
    ;

primitiveType
    : 'boolean' | 'byte' | 'char' | 'double' | 'float' | 'int' | 'long' | 'short'
    ;

typeArguments
    : '<' typeArgument (',' typeArgument)* '>'
    ;

typeArgument
    : type                                                                  # givenArgument
    | '?' (bound = ('extends' | 'super') type)?                             # wildcardArgument
    ;

typeSuffix
    : '[' low = expression '..' high = expression ']'                       # rangeSuffix
    | (dimensions += '[' ']')+                                              # arraySuffix
    ;

variable
    : declared ('=' expression)?
    ;
