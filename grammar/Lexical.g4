/*
 * Names, literals, comments and file headers: what every language of Arcomat shares.
 *
 * Keywords are soft: wherever a name may stand, a keyword may serve as one. Real models call ports
 * input, out, state or test. Only the words of expressions and the primitive types are reserved.
 */
grammar Lexical;

header
    : packageDeclaration? importDeclaration*
    ;

packageDeclaration
    : 'package' qualifiedName ';'
    ;

// Spelled out here, because a qualified name that may be followed by a dot needs lookahead everywhere.
importDeclaration
    : 'import' name ('.' name)* ('.' wildcard = '*')? ';'
    ;

qualifiedName
    : name ('.' name)*
    ;

name
    : ID
    | 'abstract' | 'aggregation' | 'alt' | 'association' | 'autoconnect' | 'autoinstantiate'
    | 'automaton' | 'behavior' | 'call' | 'causalsync' | 'class' | 'classdiagram' | 'component'
    | 'composition' | 'compute' | 'connect' | 'constraint' | 'delayed' | 'deploy' | 'derived' | 'do' | 'enum' | 'events'
    | 'exists' | 'expect' | 'extends' | 'feature' | 'final' | 'for' | 'forall' | 'implementation' | 'implements' | 'import' | 'in'
    | 'init' | 'initial' | 'input' | 'instant' | 'interface' | 'inv' | 'let' | 'off' | 'on' | 'out'
    | 'output' | 'package' | 'port' | 'ports' | 'private' | 'protected' | 'public' | 'refines'
    | 'state' | 'static' | 'super' | 'sync' | 'table' | 'test' | 'testsuite' | 'throws' | 'timed' | 'timing'
    | 'type' | 'untimed' | 'var' | 'variable' | 'varif'
    ;

// An element of an array, of ports, parts or variables, or what is no array.
place
    : name ('[' index = INT ']')?
    ;

qualifiedPlace
    : place ('.' place)*
    ;

// What is declared: as many of a name as stand behind it.
declared
    : name size?
    ;

size
    : '[' count = INT ']'
    ;

literal
    : kind = ('true' | 'false' | INT | LONG | FLOAT | DOUBLE | CHAR | STRING | 'null')
    ;

stereotypes
    : '<' '<' stereotype (',' stereotype)* '>' '>'
    ;

stereotype
    : name ('=' (literal | word = name))?
    ;

// Foreign text: kept as it is, so every token may stand in it, unknown characters included.
javaBlock
    : '{' (javaBlock | ~('{' | '}'))* '}'
    ;

// Named for the code that balances brackets; the grammars write them as they are.
LESS : '<' ;
OPEN_BRACE : '{' ;
CLOSE_BRACE : '}' ;
SEMICOLON : ';' ;

ID
    : LETTER (LETTER | MARK | [0-9])*
    ;

INT
    : INTEGER
    ;

LONG
    : INTEGER [lL]
    ;

FLOAT
    : (DECIMAL | FRACTION | WHOLE_FRACTION | HEXADECIMAL_FRACTION) [fF]
    ;

// 0..5 is a range: its first dot belongs to no number.
DOUBLE
    : (FRACTION | HEXADECIMAL_FRACTION) [dD]?
    | (DECIMAL | WHOLE_FRACTION) [dD]
    | DECIMAL '.' {_input.LA(1) != '.'}?
    ;

CHAR
    : '\'' (ESCAPE | PAIR | ~['\\\r\n]) '\''
    ;

STRING
    : '"' (ESCAPE | ~["\\\r\n])* '"'
    ;

// These two and UNKNOWN exist to be reported in plain words.
UNCLOSED_STRING
    : '"' (ESCAPE | ~["\\\r\n])*
    ;

UNCLOSED_COMMENT
    : '/*' (~'*' | '*'+ ~[*/])* '*'*
    ;

LINE_COMMENT
    : '//' ~[\r\n]* -> channel(HIDDEN)
    ;

BLOCK_COMMENT
    : '/*' .*? '*/' -> channel(HIDDEN)
    ;

SPACE
    : [ \t\r\n\f]+ -> skip
    ;

// Last, so that it takes only what no other rule takes.
UNKNOWN
    : PAIR
    | .
    ;

// A character outside of the basic plane; the lexer counts UTF-16 units.
fragment PAIR
    : '\uD800' .. '\uDBFF' '\uDC00' .. '\uDFFF'
    ;

// Combines with the letter before it, as in the decomposed form of a letter with an accent.
fragment MARK
    : '\u0300' .. '\u036F'
    ;

fragment LETTER
    : [a-zA-Z_$]
    | '\u00C0' .. '\u00D6'
    | '\u00D8' .. '\u00F6'
    | '\u00F8' .. '\u02AF'
    | '\u0391' .. '\u03A1'
    | '\u03A3' .. '\u03FF'
    | '\u0400' .. '\u0481'
    ;

fragment INTEGER
    : DECIMAL
    | '0' [xX] HEXADECIMAL
    | '0' [bB] [01] ([01_]* [01])?
    ;

fragment DECIMAL
    : [0-9] ([0-9_]* [0-9])?
    ;

fragment FRACTION
    : DECIMAL? '.' DECIMAL EXPONENT?
    | DECIMAL '.'? EXPONENT
    ;

// With a letter behind it: 5.f
fragment WHOLE_FRACTION
    : DECIMAL '.'
    ;

fragment HEXADECIMAL_FRACTION
    : '0' [xX] (HEXADECIMAL '.'? | HEXADECIMAL? '.' HEXADECIMAL) [pP] [+\-]? DECIMAL
    ;

fragment HEXADECIMAL
    : [0-9a-fA-F] ([0-9a-fA-F_]* [0-9a-fA-F])?
    ;

fragment EXPONENT
    : [eE] [+\-]? DECIMAL
    ;

fragment ESCAPE
    : '\\' ('u'+ [0-9a-fA-F] [0-9a-fA-F] [0-9a-fA-F] [0-9a-fA-F] | ~[u\r\n])
    ;
