/*
 * Components in the syntax of MontiArc 2012 (AIB-2012-03). A behaviour language is one alternative
 * of "behaviour".
 */
grammar Arc;

import Automaton, IoTable;

arcUnit
    : header (component | automaton) EOF
    ;

component
    : stereotypes? modifier* 'component' name typeParameters? parameters?
      ('extends' superType = type superArguments = componentArguments?)? ('refines' refined += refinedComponent (',' refined += refinedComponent)*)?
      namedInstance? '{' element* '}'
    ;

// Arguments choose features, and nothing else.
refinedComponent
    : qualifiedName componentArguments?
    ;

modifier
    : 'abstract' | 'deploy'
    ;

namedInstance
    : name typeArguments?
    ;

typeParameters
    : '<' typeParameter (',' typeParameter)* '>'
    ;

typeParameter
    : name ('extends' type ('&' type)*)?
    ;

parameters
    : '(' (parameter (',' parameter)*)? ')'
    | '[' (parameter (',' parameter)*)? ']'                                 // the form of 2012
    ;

parameter
    : type name ('=' expression)?
    ;

element
    : ports
    | subcomponent
    | component
    | connector
    | timing
    | autoconnect
    | autoinstantiate
    | invariant
    | behaviour
    | computation
    | features
    | constraint
    | variation
    | variables                                                             // last: begins with any type
    ;

behaviour
    : automaton
    | ioTable
    | implementation
    | foreign
    ;

ports
    : stereotypes? ('port' | 'ports') port (',' port)* ';'
    ;

port
    : stereotypes? direction = ('in' | 'out') type (size? declared (',' declared)*)?
    ;

subcomponent
    : stereotypes? 'component' type componentArguments? (instance (',' instance)*)? ';'
    ;

instance
    : declared ('[' simpleConnector (';' simpleConnector)* ']')?
    ;

simpleConnector
    : stereotypes? source = qualifiedPlace '->' targets += qualifiedPlace (',' targets += qualifiedPlace)*
    ;

connector
    : stereotypes? 'connect' source = qualifiedPlace
      '->' targets += qualifiedPlace (',' targets += qualifiedPlace)* ';'
    ;

timing
    : ('timing' | 'behavior') stereotypes?
      kind = ('instant' | 'delayed' | 'untimed' | 'causalsync' | 'sync' | 'timed') ';'
    ;

autoconnect
    : 'autoconnect' stereotypes? kind = ('type' | 'port' | 'off') ';'
    ;

autoinstantiate
    : 'autoinstantiate' stereotypes? kind = ('on' | 'off') ';'
    ;

invariant
    : kind = ID? 'inv' title = name ':' invariantBody ';'
    ;

invariantBody
    : javaBlock
    | ~('{' | ';') (~';')*
    ;

variables
    : 'var' type variable (',' variable)* ';'                               # markedVariables
    | plainType variable (',' variable)* ';'                                # plainVariables
    ;

// What there are several kinds of a component for, and what each kind has.
features
    : 'feature' name (',' name)* ';'
    ;

constraint
    : 'constraint' expression ';'
    ;

variation
    : 'varif' '(' expression ')' '{' element* '}' ('else' alternative)?
    ;

alternative
    : variation
    | '{' element* '}'
    ;

// Statements where they are some; the tools of 2017 had Java there.
computation
    : stereotypes? keyword = 'compute' name? (statements | javaBlock)
    | keyword = 'init' name? (statements | javaBlock)
    ;

implementation
    : 'implementation' name? '{' (automaton* | automatonElement+) '}'
    ;

// In the language of a guest, who knows what stands between the braces.
foreign
    : stereotypes? keyword = ID name? javaBlock
    ;
