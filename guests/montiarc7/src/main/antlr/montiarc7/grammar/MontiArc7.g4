// MontiArc 7, as far as it is converted. What is recognised only to be refused stands here too, so that findings can name it.
grammar MontiArc7;

mapping: 'mapping' name '{' mapPart* '}' EOF;
mapPart: kind=('inputMap' | 'outputMap' | 'stateMap') '{' mapEntry* '}';
mapEntry: expression '==>' expression ';';

unit: ('package' qname ';')? importing* component ';'? EOF;
importing: 'import' qname ('.' '*')? ';';
qname: name ('.' name)*;

component: stereo* 'component' name typeParameters? parameters? ('extends' parent (',' parent)*)? (name (',' name)*)? '{' element* '}';
typeParameters: '<' typeParameter (',' typeParameter)* '>';
typeParameter: name ('extends' type ('&' type)*)?;
parameters: '(' (parameter (',' parameter)*)? ')';
parameter: type name ('=' expression)?;
parent: type arguments?;
arguments: '(' (argument (',' argument)*)? ')';
argument: (name '=')? expression;

element
    : component                                                             # innerElement
    | stereo* 'port' portDeclaration (',' portDeclaration)* ';'             # portsElement
    | mark* 'mode' 'automaton' name? '{' 'initial' 'mode' name '{' element* '}' ';'? '}' # soleModeElement
    | mark* 'mode' 'automaton' name? skipped                                # modesElement
    | mark* 'automaton' name? '{' machineElement* '}'                       # automatonElement
    | mark* 'compute' block                                                 # computeElement
    | 'init' block                                                          # initElement
    | 'feature' name (',' name)* ';'                                        # featureElement
    | 'constraint' '(' expression ')' ';'                                   # constraintElement
    | ('--' | '-')* kind=('pre' | 'post') ':' expression ';'                # conditionElement
    | ('varif' | 'if') '(' expression ')' element ('else' element)?         # variationElement
    | 'timing' name ';'                                                     # timingElement
    | ('autoconnect' | 'autoinstantiate') name ';'                          # autoElement
    | '{' element* '}'                                                      # groupElement
    | portReference '->' portReference (',' portReference)* ';'             # connectorElement
    | 'final'? type field (',' field)* ';'                                  # fieldElement
    | stereo* type arguments? instance (',' instance)* ';'                  # instanceElement
    | ';'                                                                   # emptyElement
    ;

portDeclaration: mark* direction=('in' | 'out') mark* type mark* name (',' mark* name)*;
mark: stereo | 'sync' | 'timed' | 'untimed' | 'delayed';
stereo: '<' '<' stereoValue (',' stereoValue)* '>' '>';
stereoValue: name ('=' said)?;
said: '-'? literal | qname | '[' (said (',' said)*)? ']' | skipped;
portReference: name ('.' name)?;
variable: name ('=' expression)?;
field: name '=' expression;
instance: name arguments?;
type: qname typeArguments? ('[' ']')*;
typeArguments: '<' (type | '?') (',' (type | '?'))* '>';

machineElement
    : stereo* beginning? 'final'? beginning? 'state' name ('[' expression ']')? ('{' machineElement* '}')? ';'? # stateElement
    | kind=('entry' | 'exit' | 'do') '/' statement ';'?                               # actionElement
    | stereo* qname '->' qname reaction                                               # transitionElement
    | stereo* '->' reaction                                                           # innerTransitionElement
    | ';'                                                                             # emptyMachineElement
    ;
reaction: ('[' expression ']')? qname? ('/' statement | ';');
beginning: 'initial' ('/'? block)?;

block: '{' statement* '}';
statement
    : block                                                                  # blockStatement
    | 'if' '(' expression ')' statement ('else' statement)?                  # ifStatement
    | 'switch' '(' expression ')' '{' switchCase* '}'                        # switchStatement
    | 'break' ';'                                                            # breakStatement
    | 'continue' ';'                                                         # continueStatement
    | 'for' '(' 'final'? type name ':' expression ')' statement              # eachStatement
    | 'for' '(' loopStart? ';' expression? ';' (change (',' change)*)? ')' statement     # forStatement
    | 'while' '(' expression ')' statement                                   # whileStatement
    | 'do' statement 'while' '(' expression ')'                              # doStatement
    | ('return' | 'try' | 'throw' | 'assert') .*? (skipped | ';')            # otherStatement
    | expression assign=('=' | '+=' | '-=' | '*=' | '/=' | '%=') expression ';'           # assignStatement
    | expression '=' (expression step=('++' | '--') | before=('++' | '--') expression) ';' # assignStepStatement
    | expression step=('++' | '--') ';'                                            # stepStatement
    | step=('++' | '--') expression ';'                                            # stepStatement
    | 'final'? type variable (',' variable)* ';'                             # localStatement
    | expression ';'                                                         # callStatement
    | ';'                                                                    # emptyStatement
    ;
loopStart: 'final'? type variable (',' variable)* | change (',' change)*;
change
    : expression assign=('=' | '+=' | '-=' | '*=' | '/=' | '%=') expression
    | expression step=('++' | '--')
    | step=('++' | '--') expression
    ;
switchCase: ('case' expression | 'default') ':' statement*;
skipped: '{' (skipped | ~('{' | '}'))* '}';

expression
    : literal                                                                # literalExpression
    | name                                                                   # nameExpression
    | '(' expression ')'                                                     # bracketExpression
    | expression '.' name                                                    # memberExpression
    | expression '(' (expression (',' expression)*)? ')'                     # callExpression
    | expression '[' expression ']'                                          # indexExpression
    | '[' (expression (',' expression)*)? ']'                                 # listExpression
    | 'new' type .*? '(' (expression (',' expression)*)? ')'                 # newExpression
    | op=('!' | '-' | '+' | '~') expression                                  # prefixExpression
    | '(' type ')' expression                                                # castExpression
    | expression op=('*' | '/' | '%') expression                             # binaryExpression
    | expression op=('+' | '-') expression                                   # binaryExpression
    | expression shift expression                                            # shiftExpression
    | expression op=('<=' | '>=' | '<' | '>') expression                     # binaryExpression
    | expression op=('==' | '!=') expression                                 # binaryExpression
    | expression op='&' expression                                           # bitExpression
    | expression op='^' expression                                           # bitExpression
    | expression op='|' expression                                           # bitExpression
    | expression op='&&' expression                                          # binaryExpression
    | expression op='||' expression                                          # binaryExpression
    | expression op=('implies' | '<=>') expression                           # binaryExpression
    | <assoc = right> expression '?' expression ':' expression               # choiceExpression
    ;
shift: '<' '<' | '>' '>' | '>' '>' '>';
literal: Number | Text | Letter | 'true' | 'false' | 'null';

// Words that are names elsewhere.
name
    : Name | 'in' | 'out' | 'port' | 'sync' | 'timed' | 'untimed' | 'delayed' | 'mode' | 'automaton' | 'compute' | 'init'
    | 'mapping' | 'inputMap' | 'outputMap' | 'stateMap' | 'feature' | 'constraint' | 'timing' | 'autoconnect' | 'autoinstantiate' | 'state' | 'initial' | 'entry' | 'exit'
    | 'pre' | 'post'
    ;

Number: [0-9] [0-9_]* ('.' [0-9]+)? ([eE] [+-]? [0-9]+)? [lLfFdD]? | '0' [xX] [0-9a-fA-F]+ [lL]?;
Text: '"' (~["\\\r\n] | '\\' .)* '"';
Letter: '\'' (~['\\\r\n] | '\\' .)+? '\'';
Name: [\p{L}_$] [\p{L}\p{N}_$]*;
Comment: ('/*' .*? '*/' | '//' ~[\r\n]*) -> channel(HIDDEN);
Space: [ \t\r\n\f]+ -> skip;
