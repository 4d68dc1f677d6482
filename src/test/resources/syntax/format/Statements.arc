component Statements{port in Integer p,out Integer o;int a=0;
automaton{initial    state s,t;initial{o=1}state u;initial do{o=2;}s;
 initial do{}state v;
s->t[a>0]{p==?}/do{a=p;b+=a;a-=b+1;a++;b--;o=--;o=[a,b];int c=1,d;var Boolean e=a>b&&b>a;

if(a>b)a=1;
  // about the choice
if(a>b){a=1;/* inside */}else b=2;
if(a>b){}else if(b>a){Integer k=a;o=k; // behind
}else{{o=3;}

o=4;
}
a = 1111111111 + 1111111111 + 1111111111 + 1111111111 + 1111111111 + 1111111111 + 1111111111 + 1111111111;
};
s->s/do{}; s / do { // first
a = 1; };
}}
