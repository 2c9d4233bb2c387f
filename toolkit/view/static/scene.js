var Ki=i=>Object.fromEntries(Object.entries(i).map(([t,e])=>[t,Float64Array.from(e)])),Ai=(i,t)=>[i[t],i[t+1],i[t+2]];function Mr(i,t,e){let n=Ki(i),[s,r,o,a]=i.history.slice(-4),l=e[0]*a-e[1]*o,c=e[0]*o+e[1]*a,h=(d,u)=>[c*d+l*u,c*u-l*d];for(let d of[n.history,n.future])for(let u=0;u<d.length;u+=4)d.set([...t,...e],u);n.facing.set(e);for(let d=0;d<n.toes.length;d+=3){let[u,f]=h(i.toes[d]-s,i.toes[d+2]-r);n.toes[d]=t[0]+u,n.toes[d+2]=t[1]+f}return n}var dn=(i,t,e)=>i+e*(t-i),Un=(i,t,e)=>Math.min(Math.max(i,t),e);function ue(i){let t=0;for(let n of i)t+=n*n;let e=Math.max(Math.sqrt(t),1e-12);return i.map(n=>n/e)}function bc(i,t,e,n,s,r=1/0){let o=s*Math.atan2(t*e-i*n,i*e+t*n),a=Math.atan2(i,t)+Un(o,-r,r);return[Math.sin(a),Math.cos(a)]}function wc(i,t,e){let n=i.length-4*(1+t),s=n-4*e.half_second,r=e.fps/e.half_second;return[(i[n]-i[s])*r,(i[n+1]-i[s+1])*r]}function Nm(i,t,e,n){let s=Math.hypot(...e);if(s<=n.moves)return dn(t,1,.05);let[r,o]=ue(e),[a,l]=[0,1].map(h=>{let[d,u]=wc(i,h,n);return Un((s-(d*r+u*o))/Math.max(s,.5),-1,1)}),c=n.proportional*(a-l)+n.integral/n.fps*a;return Un(t+Math.max(t,1)*c,0,n.max_drive)}var Qu=(i,t)=>Un((i-t.moves)/(t.slow-t.moves),0,1);function Um(i,t,e,n){let s=t.map((d,u)=>dn(i.asked[u],d,e.asked)),[r,o]=ue(t),a=wc(i.history,0,e),l=(a[0]-s[0])*o-(a[1]-s[1])*r,c=Math.hypot(...t);n.asked.set(s),n.aside[0]=c>e.moves?Un(i.aside[0]+e.sideways_sum*l,-1,1):e.forget*i.aside[0];let h=Qu(c,e)*(e.sideways*l+n.aside[0])*Math.max(i.drive[0],1);return[-h*o,h*r]}function ju({rest:i,facing:t},[e,n],{may_stand:s,aligned:r}){return i[0]*Un((e*t[0]+n*t[1]-s)/(r-s),0,1)}function td(i,t,e,n,s){let{history:r,future:o}=i,a=s.future,l=r.length-4,c=[0,1].map(D=>e.gain*(t.velocity[D]-i.velocity[D])),h=e.fastest/Math.max(Math.hypot(...c),e.fastest),d=[0,1].map(D=>i.velocity[D]+h*c[D]),u=Math.hypot(...d),f=Math.hypot(...t.facing)>1e-6?bc(...i.facing,...t.facing,e.gain,e.spin):i.facing;s.velocity.set(d),s.facing.set(f);let m=i.drive[0],v=Un(i.rest[0]+(u<e.moves?e.standing:-e.starting),0,1);s.drive[0]=Nm(r,m,d,e),s.rest[0]=v;let p=e.stand_still*Math.max(1-Math.min(u/e.slow,m/e.low),0),g=Um(i,d,e,s),x=wc(r,0,e),b=Math.min(Math.hypot(...t.velocity)/Math.max(Math.hypot(...x),e.slow),1),M=Un(2-Math.hypot(...x)/e.slow,0,1),E=(x[0]*d[0]+x[1]*d[1])/(e.low*Math.max(u*u,1e-6)),S=Qu(u,e)*M*Un(1-E,0,1),_=d.map((D,L)=>m*D+p*(dn(D,s.asked[L],b)-x[L])+g[L]),y=r[l],R=r[l+1],A=r[l+2],C=r[l+3],N=y,O=R;a.set(r.subarray(l));for(let D=1;D<e.position_shares.length;D++){let L=4*D,B=dn(e.position_shares[D],1,Math.max(v,S));N+=dn(o[L]-o[L-4],_[0]*e.seconds[D],B),O+=dn(o[L+1]-o[L-3],_[1]*e.seconds[D],B),a[L]=N,a[L+1]=O,a.set(bc(o[L+2],o[L+3],f[0],f[1],dn(e.direction_shares[D],1,v)),L+2)}let{samples:I}=e,k=I.length-e.position_shares.length;for(let D=0;D<I.length;D++){let[L,B]=D<k?[r,4*I[D]]:[a,4*(D-k)],z=e.trajectory_in+4*D,F=L[B]-y,X=L[B+1]-R,et=L[B+2],W=L[B+3];n[z]=C*F-A*X,n[z+1]=A*F+C*X,n[z+2]=C*et-A*W,n[z+3]=A*et+C*W}n.set(i.joints,e.joints_in)}function Om({history:i,joints:t},e){let[n,s,r,o]=i.subarray(i.length-4),[a,l]=ue([r,o]);return e.legs.map(([,,c])=>{let[h,d,u]=Ai(t,e.width*c+e.position);return[l*h+a*u+n,d,l*u-a*h+s]})}function ed(i,t,e,n){let[s,r]=[i,t].map(u=>Om(u,n)),[o,a]=t.history.slice(-2),l=[a,-o],c=1/n.fps,h=Math.exp(-n.let_go*c),d=Math.min(...t.contacts)>n.both?n.settle:0;for(let u of[0,1]){let f=r[u],m=r[1-u],v=l.map(k=>u?-k:k),p=f.map((k,D)=>i.toes[3*u+D]-s[u][D]),g=p.map((k,D)=>i.drift[3*u+D]+n.let_go*k),x=t.contacts[u],b=x>.5,E=x>i.contacts[u]&&f[1]<n.ground+n.uneven?Math.min(2*x,1)*Math.min(2*i.contacts[1-u],1):0,S=b?[1,1,1]:[E,0,E],_=f.map((k,D)=>i.toes[3*u+D]-k),y=n.slack/Math.max(Math.hypot(..._),n.slack),R=p.map((k,D)=>dn(h*(k+g[D]*c),_[D]*y,S[D])),A=(m[0]-f[0])*v[0]+(m[2]-f[2])*v[1],C=Math.max(R[0]*v[0]+R[2]*v[1]-Math.max(A/4,n.near),0),N=n.ground-f[1]-R[1],O=d||b?Math.max(-N-n.uneven-n.heel*Math.max(e[u],0),N-n.sunk,0):0,I=d+O*n.level;R=[R[0]-C*v[0],R[1]+Un(N,-I,I),R[2]-C*v[1]];for(let k of[0,1,2])t.drift[3*u+k]=S[k]>0?(R[k]-p[k])/c:h*(i.drift[3*u+k]-n.let_go*g[k]*c);t.toes.set(f.map((k,D)=>k+R[D]),3*u)}}function Fm(i,t,[e,n],[s,r],o,a,l,c){let{position:h,forward:d,up:u,velocity:f,width:m,joints_out:v}=l,p=new Float64Array(i.length/m).fill(.5);l.legs.forEach((E,S)=>E.forEach(_=>p[_]*=1-Math.min(2*o[S],1)));let g=new Float64Array(p.length).fill(l.jump);for(let E of l.legs.flat())g[E]=1e6;let x=new Float64Array(p.length);l.legs.forEach(([,,E],S)=>x[E]=l.lift*(1-Math.min(2*o[S],1)));let b=(E,S,_,y)=>(c[E]=n*S+e*y,c[E+1]=_,c[E+2]=n*y-e*S),M=(E,S)=>S.map((_,y)=>dn(_,i[E+y],a));for(let E=0;E<i.length;E+=m){let S=v+E,_=S+h,y=S+f,R=E+h,[A,C,N]=ue(M(E+d,Ai(t,S+d))),[O,I,k]=M(E+u,Ai(t,S+u)),D=O*A+I*C+k*N,L=ue([O-D*A,I-D*C,k-D*N]),B=p[E/m],z=[0,1,2].map(U=>B*(t[_+U]-i[R+U]-t[y+U]/l.fps)),F=g[E/m],X=F/Math.max(Math.hypot(...z),F),et=U=>i[R+U]+t[y+U]/l.fps+X*z[U],W=x[E/m]*Math.min(Math.max(et(1)-l.ground,0),l.high);b(R,...M(R,[et(0),et(1)+W,et(2)])),b(E+d,A,C,N),b(E+u,L[0],L[1],L[2]),b(E+f,t[y],t[y+1],t[y+2]),c[R]+=s,c[R+2]+=r}}function nd(i,t,e,n){let{history:s,future:r}=n,o=s.length-4,[a,l,c,h]=i.history.subarray(o);s.set(i.history.subarray(4));for(let S=0;S<e.position_shares.length;S++){let _=e.trajectory_out+4*S,y=4*S,[R,A]=ue([t[_+2],t[_+3]]),C=[h*t[_]+c*t[_+1]+a,h*t[_+1]-c*t[_]+l],N=[h*R+c*A,h*A-c*R];if(S===0){let O=bc(...N,c,h,ju(n,[c,h],e));s.set([dn(C[0],a,n.rest[0]),dn(C[1],l,n.rest[0]),...O],o),r.set(s.subarray(o))}else{let O=[...C,...N].map((I,k)=>dn(r[y+k],I,e.correction));r.set([O[0],O[1],...ue(O.slice(2))],y)}}let[d,u,f,m]=s.subarray(o),v=a-d,p=l-u,g=ue([c*m-h*f,h*m+c*f]),x=ju(n,[c,h],e);for(let S of[0,1]){let _=Un(t[e.contacts+S],0,1),y=i.toes[3*S+1]<e.ground+e.lifted;n.contacts[S]=x>e.stands&&y?Math.max(_,Math.min(i.contacts[S]+e.landing,1)):_}let b=Math.hypot(...n.velocity)>e.moves?n.rest[0]:0,M=[m*v-f*p,f*v+m*p];Fm(i.joints,t,g,M,n.contacts,b,e,n.joints);let E=Math.max(x*Math.min(...n.contacts),b);for(let S=0;S<n.phase.length;S+=2){let _=[0,1].map(A=>t[e.updates+S+A]),y=_.map((A,C)=>i.phase[S+C]+A),R=Math.min(e.pull*Math.hypot(..._)/Math.max(Math.hypot(...y),1e-6),.5);for(let A of[0,1])n.phase[S+A]=dn(dn(y[A],t[e.phases+S+A],R),i.phase[S+A],E)}}function Bm(i,t,e){let n=Math.imul(t,2654435761)+Math.imul(e,2246822519)|0;return Float64Array.from({length:i},(s,r)=>{let o=Math.imul(r,3266489917)+n|0;return o=Math.imul(o^o>>>16,2146121005),o=Math.imul(o^o>>>15,2221713035),Math.sqrt(3)*(((o^o>>>16)>>>0)/2**31-1)})}var bs=class{constructor(t,e,n=0){Object.assign(this,{amount:t,period:e,seed:n,keys:new Map})}key(t,e){return this.keys.has(t)||(this.keys.delete(t-2),this.keys.set(t,Bm(e,t,this.seed))),this.keys.get(t)}at(t,e){if(!this.amount)return e;let n=Math.floor(t/this.period),s=t/this.period-n,r=Math.PI/2*s*s*(3-2*s),o=Math.cos(r),a=Math.sin(r),[l,c]=[this.key(n,e.length),this.key(n+1,e.length)],h=d=>Math.floor(4*d/e.length)%2;return e.map((d,u)=>d*(1+this.amount*h(u)*(o*l[u]+a*c[u])))}};var km=(()=>{let i;return()=>i??=Float32Array.from({length:65536},(t,e)=>{let n=e>>15?-1:1,s=e>>10&31,r=e&1023;return s===31?r?NaN:n*(1/0):n*(s?(1+r/1024)*2**(s-15):r*5960464477539063e-23)})})();function Ke(i,t){let e=atob(i),n=new Uint8Array(e.length);for(let s=0;s<e.length;s++)n[s]=e.charCodeAt(s);return new t(n.buffer)}function qn({type:i,data:t}){if(i==="float32")return Ke(t,Float32Array);let e=km();return Float32Array.from(Ke(t,Uint16Array),n=>e[n])}var Sr=Array.from({length:4},(i,t)=>t);function ri(i){let t=[];for(;i>127;i>>>=7)t.push(i&127|128);return[...t,i]}var od=i=>(i=i.flat(1/0),[ri(i.length),i]),qo=i=>[ri(i.length),i],Ec=i=>qo([...i].map(t=>t.charCodeAt(0))),ie=i=>[32,ri(i)],je=(i,t)=>[t,33,ri(i)],He=i=>[65,i<64?i:[i&127|128,i>>7]],Ti=(i,t)=>[i,t,106],On=(i,t)=>[i,t,108],ii=(i,t)=>je(i,Ti(ie(i),t)),Xo=(i,t,...e)=>[3,64,e,ie(i),t,73,13,0,11],si=i=>[253,ri(i)],zm=[si(12),Array(16).fill(0)],Gm=(i,t)=>[i,si(0),0,ri(t)],id=(i,t)=>[i,si(10),0,ri(t)],sd=(i,t)=>[i,si(93),0,ri(t),si(95)],Hm=(i,t,e)=>[i,e,si(11),0,ri(t)],Ac=(i,t)=>[i,t,si(240)],ad=(i,t)=>[i,t,si(242)],Vm=(i,t,e,n)=>n?[t,e,i,si(263)]:Ac(i,ad(t,e)),Wm=(i,t)=>od([qo(i),t,11]);function rd(i,t){let[e,n,s,r,o,a,l]=Array.from({length:7},(k,D)=>D),c=i?8:7,[h,d,u,f,m,v,p,g,x,b]=Array.from({length:10},(k,D)=>c+D),M=i?[0,1]:[0,1,2,3],E=8/M.length,S=c+10,_=S+1,y=(k,D)=>_+4+E*k+D,R=(k,D,L)=>je(y(k,D%E),Vm(ie(y(k,D%E)),ie(_+D),L,t)),A=[Sr.map(k=>M.map(D=>R(D,k,sd(ie(m),4*(8*k+2*D))))),ii(m,He(128))],C=[M.map(k=>[je(S,sd(ie(m),8*k)),Sr.map(D=>R(k,D,ie(S)))]),ii(m,He(32))],N=(k,D,L,B)=>{let z=16*(k+2*D);return Hm(ie(x),z,Ac(Gm(ie(x),z),ad(id(ie(g),8*L),B)))},O=k=>[Sr.map(D=>[0,4].map(L=>je(y(0,0)+L+D,zm))),je(m,Ti(ie(f),He(16*k))),je(v,Ti(ie(m),On(ie(o),He(32)))),je(p,i?Ti(ie(s),On(On(ie(u),ie(o)),He(32))):ie(s)),Xo(m,ie(v),Sr.map(D=>je(_+D,id(ie(p),8*D))),i?C:A,ii(p,He(32))),je(x,Ti(ie(e),On(ie(h),He(64)))),i?[je(g,Ti(ie(r),On(Ti(On(ie(u),ie(a)),ie(d)),He(32)))),ii(x,On(ie(u),On(ie(b),He(4)))),Sr.map(D=>[M.map(L=>N(L,k,D,ie(y(L,D)))),ii(x,ie(b))])]:[je(g,Ti(ie(r),On(ie(d),He(8)))),M.map(D=>N(D,k,0,Ac(ie(y(D,0)),ie(y(D,1)))))]],I=[je(f,ie(n)),je(b,On(ie(l),He(64))),je(h,He(0)),Xo(h,ie(l),je(d,He(0)),Xo(d,ie(a),je(u,He(0)),i?Xo(u,ie(c-1),O(0),O(1),ii(u,He(1))):O(0),ii(f,On(ie(o),He(32))),ii(d,He(1))),ii(h,He(1)))];return Wm([[10,127],[13,123]],I)}function Xm(i){let t=(n,s)=>[n,od(qo(s))],e=Object.values(i);return Uint8Array.from([0,97,115,109,1,0,0,0,t(1,e.map(([n])=>[96,qo(Array(n).fill(127)),0])),t(2,[[Ec("page"),Ec("memory"),2,0,1]]),t(3,e.map((n,s)=>s)),t(7,Object.keys(i).map((n,s)=>[Ec(n),0,s])),t(10,e.map(([,n])=>n))].flat(1/0))}function Tc(i=!0){try{let t=new WebAssembly.Memory({initial:1}),e=new WebAssembly.Module(Xm({many:[8,rd(!0,i)],one:[7,rd(!1,i)]}));return{...new WebAssembly.Instance(e,{page:{memory:t}}).exports,memory:t,fused:i}}catch{return i?Tc(!1):null}}var Ve=8,$o=4,Rc=8,qm=65536,Cc=(i,t)=>t*Math.ceil(i/t);function ld(i){let t=1/(1+.5*Math.abs(i)),e=[.17087277,-.82215223,1.48851587,-1.13520398,.27886807,-.18628806,.09678418,.37409196,1.00002368],n=t*Math.exp(-i*i-1.26551223+t*e.reduce((s,r)=>r+t*s,0));return i>=0?n:2-n}function $m(i,t){let e=Math.max(t,1e-6),n=i/e,s=.5*ld(n*Math.SQRT1_2),r=Math.exp(Math.min(i+.5*e*e,60))*.5*ld((n+e)*Math.SQRT1_2);return i*(1-s)+e*Math.exp(-.5*n*n)/Math.sqrt(2*Math.PI)+r-s}var cd=i=>i>0?i:Math.exp(i)-1;function hd(i,t,e,n,{rows:s,experts:r,panels:o}){for(let a=0,l=0;a<Ve*o;a+=Ve)for(let c=0;c<r;c++){let h=0,d=0,u=0,f=0,m=0,v=0,p=0,g=0;for(let b=0;b<s;b++,l+=Ve){let M=e[b];h+=M*t[l],d+=M*t[l+1],u+=M*t[l+2],f+=M*t[l+3],m+=M*t[l+4],v+=M*t[l+5],p+=M*t[l+6],g+=M*t[l+7]}let x=n[c];i[a]+=x*h,i[a+1]+=x*d,i[a+2]+=x*u,i[a+3]+=x*f,i[a+4]+=x*m,i[a+5]+=x*v,i[a+6]+=x*p,i[a+7]+=x*g}}function Ym(i,t,e){let n=new Float32Array(i.length/t*e);for(let s=0,r=0;s<i.length;s+=Ve*t,r+=Ve*e)n.set(i.subarray(s,s+Ve*t),r);return n}var ws=class{constructor({means:t,deviations:e,gating:n,experts:s,epsilon:r,dropped:o},{plain:a=!1}={}){Object.assign(this,{means:t.map(qn),deviations:e.map(qn),epsilon:r,dropped:o,count:0}),this.gating=n.layers.map((c,h)=>({weights:qn(c),x:new Float64Array(n.widths[h]+1).fill(1),y:new Float64Array(Cc(n.widths[h+1],Ve)),rows:n.widths[h]+1,experts:1,panels:Math.ceil(n.widths[h+1]/Ve)}));let l=0;this.experts=s.layers.map((c,h)=>{let d=s.widths[h]+1,u=Cc(d,$o),f=Ym(qn(c),d,u),m=l;return l+=4*f.length,{weights:f,at:m,inputs:d,rows:u,experts:s.count,panels:Math.ceil(s.widths[h+1]/Ve)}}),this.weights=l,this.simd=a?null:Tc(),this.reserve(1)}reserve(t){if(t<=this.count)return;this.count=t>1?Cc(t,$o):1;let[{experts:e}]=this.experts,n=Math.max(...this.experts.map(({panels:c})=>Ve*c)),s=[...this.experts.map(({rows:c})=>c),e,n].map(c=>c*this.count),r=this.weights+Rc*s.reduce((c,h)=>c+h),o=!this.memory;if(this.simd){let{memory:c}=this.simd,h=Math.ceil((r-c.buffer.byteLength)/qm);h>0&&c.grow(h),this.memory=c.buffer}else this.memory=new ArrayBuffer(r);for(let c of this.experts){let h=new Float32Array(this.memory,c.at,c.weights.length);(o||!this.simd)&&h.set(c.weights),c.weights=h}let a=this.weights,l=s.map(c=>new Float64Array(this.memory,(a+=Rc*c)-Rc*c,c));this.experts.forEach((c,h)=>c.x=l[h]),[this.gates,this.y]=l.slice(-2)}place(t,e,n){let s=this.simd&&e>1?$o:1;return[s*n*Math.floor(t/s)+t%s,s]}predict(t){let[e,n,s]=this.experts,[r,,o]=this.means,[a,,l]=this.deviations,c=t.length;this.reserve(c),t.forEach(({x:h,phase:d},u)=>{let[f,m]=this.place(u,c,e.rows);this.gate(d,u,c);for(let v=0;v<h.length;v++)e.x[f+v*m]=(h[v]-r[v])/a[v]}),this.blend(e,c),t.forEach(({style:h},d)=>this.modulate(e,h,0,n,d,c)),this.blend(n,c),t.forEach(({style:h},d)=>this.modulate(n,h,h.length/2,s,d,c)),this.blend(s,c),t.forEach(({z:h},d)=>{let u=Ve*s.panels*d;for(let f=0;f<h.length;f++)h[f]=this.y[u+f]*l[f]+o[f]})}gate(t,e,n){let[s,r,o]=this.gating,a=this.means[1],l=this.deviations[1],[{experts:c}]=this.experts;for(let p=0;p<t.length;p++)s.x[p]=(t[p]-a[p])/l[p];let h=p=>hd(p.y.fill(0),p.weights,p.x,[1],p);for(let[p,g]of[[s,r],[r,o]]){h(p);for(let x=0;x<g.x.length-1;x++)g.x[x]=cd(p.y[x])}h(o);let[d,u]=this.place(e,n,c),{gates:f}=this,m=-1/0,v=0;for(let p=0;p<c;p++)m=Math.max(m,o.y[p]);for(let p=0;p<c;p++)v+=o.y[p]=Math.exp(o.y[p]-m);for(let p=0;p<c;p++)f[d+p*u]=o.y[p]/v}blend(t,e){let{at:n,weights:s,x:r,inputs:o,rows:a,experts:l,panels:c}=t,{y:h,gates:d,simd:u}=this;for(let f=0;f<e;f++){let[m,v]=this.place(f,e,a);r[m+(o-1)*v]=1}if(h.fill(0),u)e===1?u.one(h.byteOffset,n,r.byteOffset,d.byteOffset,a,l,c):u.many(h.byteOffset,n,r.byteOffset,d.byteOffset,a,l,c,Math.ceil(e/$o));else for(let f=0;f<e;f++){let[m]=this.place(f,e,a),[v]=this.place(f,e,l);hd(h.subarray(Ve*c*f),s,r.subarray(m),d.subarray(v),t)}}scatter({weights:t,x:e,inputs:n,rows:s,experts:r,panels:o},a,l){let[c,h]=this.place(a,l,s),[d]=this.place(a,l,r),u=new Float64Array(Ve*o);for(let f=0,m=0;f<u.length;f+=Ve,m+=Ve*s*r)for(let v=0;v<n-1;v++)for(let p=0;p<Ve;p++){let g=0;for(let x=0;x<r;x++)g+=this.gates[d+x*h]*t[m+Ve*(x*s+v)+p];g*=e[c+v*h],u[f+p]+=this.dropped*g*g}return u}modulate(t,e,n,s,r,o){let a=e.length/4,l=this.y.subarray(Ve*t.panels*r),c=s.x,h=this.dropped?this.scatter(t,r,o):null,[d,u]=this.place(r,o,s.rows),f=0,m=0,v=0;for(let g=0;g<a;g++)f+=l[g];f/=a;for(let g=0;g<a;g++)m+=(l[g]-f)**2;if(h){for(let x=0;x<a;x++)v+=h[x]/a;let g=1/(Math.sqrt(m/(a-1)+v)+this.epsilon);for(let x=0;x<a;x++){let b=e[n+x],M=Math.abs(b)*Math.sqrt(h[x])*g;c[d+x*u]=$m(b*(l[x]-f)*g+e[n+a+x],M)}return}let p=1/(Math.sqrt(m/(a-1))+this.epsilon);for(let g=0;g<a;g++)c[d+g*u]=cd(e[n+g]*(l[g]-f)*p+e[n+a+g])}};var se=(i,t,e=1)=>[i[0]+e*t[0],i[1]+e*t[1],i[2]+e*t[2]],$t=(i,t)=>se(i,t,-1),ji=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2],rn=(i,t)=>[i[1]*t[2]-i[2]*t[1],i[2]*t[0]-i[0]*t[2],i[0]*t[1]-i[1]*t[0]];function dd(i){let[t,e,n]=i.map(Math.abs),s=t<=e&&t<=n?0:e<=n?1:2;return ue(rn(i,[0,1,2].map(r=>+(r===s))))}var xn=(i,t)=>[i[0]*t[0]-i[1]*t[1]-i[2]*t[2]-i[3]*t[3],i[0]*t[1]+i[1]*t[0]+i[2]*t[3]-i[3]*t[2],i[0]*t[2]-i[1]*t[3]+i[2]*t[0]+i[3]*t[1],i[0]*t[3]+i[1]*t[2]-i[2]*t[1]+i[3]*t[0]];function fn([i,...t],e){let n=rn(t,e).map(s=>2*s);return se(se(e,n,i),rn(t,n))}function Qi(i,t){let e=ue(i),n=ue(t),s=1+ji(e,n);return s<1e-6?[0,...dd(e)]:ue([s,...rn(e,n)])}function Pc(i,t){let e=ue(i),n=ue(rn(t,e)),s=rn(e,n),r=[1+n[0]+s[1]+e[2],1+n[0]-s[1]-e[2],1-n[0]+s[1]-e[2],1-n[0]-s[1]+e[2]],o=s[2]-e[1],a=e[0]-n[2],l=n[1]-s[0],c=s[0]+n[1],h=e[0]+n[2],d=e[1]+s[2],u=r.indexOf(Math.max(...r)),f=ue([[r[0],o,a,l],[o,r[1],c,h],[a,c,r[2],d],[l,h,d,r[3]]][u]);return f[0]<0?f.map(m=>-m):f}function br(i,t,e,n,s,{soft:r,straight:o},a=null){let l=$t(n,i),c=Math.hypot(...$t(t,i)),h=Math.hypot(...$t(e,t)),d=Math.hypot(...l),u=c+h,f=Math.max(r*u,1e-9),m=ue(d>1e-9?l:se($t(e,i),[1,1,1],1e-9)),v=d-(u-f),p=Math.max(v>0?u-f*Math.exp(-v/f):d,Math.abs(c-h)+1e-6*u),g=ue(a??fn(Qi($t(e,i),m),$t(t,i))),x=se(g,m,-ji(g,m));if(s){let S=rn(m,ue(s));x=se(x,S,-2*Math.min(ji(x,S),0)),x=se(x,S,Math.max(o-Math.hypot(...x),0))}let b=Math.hypot(...x)>1e-5?ue(x):dd(m),M=(c**2-h**2+p**2)/(2*p),E=Math.sqrt(Math.max(c**2-M**2,0));return[se(se(i,m,M),b,E),se(i,m,p)]}function oi(i,t,e){for(let n=1;n<e.length;n++){let s=i.parents[n];e[n]=se(e[s],fn(t[s],i.offsets[n]))}}function Zm(i,t,e,n){oi(i,t,e);for(let[s,r]of i.arms){let o=fn(t[s],i.offsets[r]),a=Qi(o,$t(n(r),e[s]));t[s]=xn(a,t[s]),e[r]=se(e[s],fn(a,o))}}function ud(i,t,e,n){oi(i,t,e);let s=$t(...[1,0].map(r=>e[i.legs[r][0]]));i.legs.forEach(([r,o,a,l],c)=>{let[h,d,u]=[r,o,a].map(v=>e[v]),[f,m]=br(h,d,u,se($t(Ai(n,3*c),e[l]),u),s,i);t[r]=xn(Qi($t(d,h),$t(f,h)),t[r]),t[o]=xn(Qi($t(u,d),$t(m,f)),t[o])})}function Jm([i,t],e,{fps:n,let_go:s,fall:r}){let o=Math.min(e,i+r/n),a=Math.exp(-s/n),l=t+s*(i-o),c=a*(i-o+l/n);return c>0?[o+c,a*(t-s*l/n)]:[o,(o-i)*n]}function Km({history:i,joints:t},e,n){let[s,r]=ue(i.slice(-2)),o=n.width*n.legs[e][1],a=([l,c,h])=>[r*l+s*h,c,r*h-s*l];return Pc(...["forward","up"].map(l=>a(Ai(t,o+n[l]))))}function jm(i,t,e,{let_go:n,fps:s,swivel:r},[[o,...a],l]){let[c,,h]=xn(l,[o,...a.map(v=>-v)]),d=i.swivel[e],u=Math.exp(-n/s)*d,f=d-2*Math.atan2(c>0?h:-h,Math.abs(c)),m=Math.min(2*t.contacts[e],1);return u+m*(Math.min(Math.max(f,-r),r)-u)}var fd=i=>[Math.cos(i/2),0,Math.sin(i/2),0];function Qm(i,t,e,n){let[s,,r]=ue([t[0],0,t[2]]),[o,,a]=$t(i[1].target,i[0].target),l=o*s+a*r,c=Math.abs(a*s-o*r);i.forEach((h,d)=>{let u=n.aside*h.length-n.crossing*Math.max(c-n.passed*h.length,0),f=(d?1:-1)*Math.min(Math.max(u-l,0),n.push)*(1-Math.min(2*e[d],1));h.target=se(h.target,[s,0,r],f)})}function pd(i,t,e,n){let{history:s,joints:r,toes:o,contacts:a,drop:l,swivel:c}=i;ed(t,i,e.legs.map(([,,E,S],_)=>{let y=[t,i].map(A=>Km(A,_,n)),R=S===E?[0,0,0]:e.offsets[S];return c[_]=jm(t,i,_,n,y),fn(y[1],R)[1]-R[1]}),n);let h=(E,S)=>Ai(r,n.width*E+n[S]),[d,u,f,m]=s.subarray(s.length-4),[v,p]=ue([f,m]),g=[h(0,"position")];for(let E of e.chains){let S=e.parents[E],_=e.features[S];g[E]=se(g[S],fn(Pc(h(_,"forward"),h(_,"up")),e.offsets[E]))}let x=0,b=e.legs.map(([E,S,_,y],R)=>{let[A,C,N]=Ai(o,3*R),[O,I,k]=[E,S,_].map(B=>g[B]),D=fn(fd(c[R]),$t(g[y],k)),L=Math.hypot(...$t(I,O))+Math.hypot(...$t(k,I));return{a:O,b:I,ankle:k,sole:D,length:L,target:$t([p*(A-d)-v*(N-u),C,p*(N-u)+v*(A-d)],D)}}),M=$t(b[1].a,b[0].a);Qm(b,M,a,n),b.forEach(({a:E,length:S,target:_},y)=>{let[R,A,C]=$t(E,_),N=A-Math.sqrt(Math.max(((1-n.soft)*S)**2-R*R-C*C,(S/2)**2)),O=n.room*S,I=N>O?N:Math.max(N+O,0)**2/(4*O);x=Math.max(x,Math.min(I,n.deepest*S)*Math.min(2*a[y],1))}),l.set(Jm(t.drop,x,n)),b.forEach(({a:E,b:S,ankle:_,sole:y,target:R},A)=>{let[,C,N,O]=e.legs[A],I=Math.min(2*a[A],1),k=z=>[z[0],z[1]-l[0],z[2]],D=R;if(I<1){[,D]=br(k(E),k(S),k(_),R,M,{straight:e.straight,soft:n.swing+I*(n.soft-n.swing)});let[z,F,X]=se(D,y);o.set([p*z+v*X+d,F,p*X-v*z+u],3*A)}let[L,B]=br(E,S,_,D,M,e);[[C,L],[N,B],[O,se(B,y)]].forEach(([z,F])=>r.set(F,n.width*e.own[z]+n.position))})}function md({history:i,joints:t,toes:e,drop:n,swivel:s},r,o,{feet:a,arms:l},c,h,d=null){let[u,f,m,v]=i.subarray(i.length-4),[p,g]=ue([m,v]),x=(S,_)=>{let y=o.width*S+o[_];return[g*t[y]+p*t[y+2],t[y+1],g*t[y+2]-p*t[y]]},b=()=>{for(let S of r.ends)M[S]=M[r.parents[S]]},M=r.features.map(S=>Pc(x(S,"forward"),x(S,"up")));a&&r.legs.forEach((S,_)=>new Set(S.slice(2)).forEach(y=>M[y]=xn(fd(s[_]),M[y])));let E=r.parents.map(()=>se([u,0,f],x(0,"position")));l&&(Zm(r,M,E,S=>se([u,0,f],x(r.own[S],"position"))),b()),a&&(E[0][1]-=n[0],ud(r,M,E,e),b()),d?.(M,E,S=>{ud(r,M,E,S.flat()),b()}),h.set(E[0]),c.set(M[0]);for(let S=1;S<M.length;S++){let[_,...y]=M[r.parents[S]];c.set(xn([_,...y.map(R=>-R)],M[S]),4*S)}}var ts=class{constructor({network:t,rules:e,body:n,start:s},r=new ws(t)){let[o,,a]=r.means;Object.assign(this,{rules:e,body:n,first:s,network:r}),this.x=new Float64Array(o.length),this.z=new Float64Array(a.length),this.rotations=new Float64Array(4*n.parents.length),this.root=new Float64Array(3),this.restart()}restart(){this.state=Ki(this.first),this.spare=Ki(this.first)}step(t,e){Es([this],[t],[e])}pose(t={feet:!0,arms:!0},e=null){md(this.state,this.body,this.rules,t,this.rotations,this.root,e)}};function Es(i,t,e){let[{network:n,rules:s}]=i;i.forEach(({state:r,spare:o,x:a},l)=>td(r,t[l],s,a,o)),n.predict(i.map(({state:r,x:o,z:a},l)=>({x:o,z:a,phase:r.phase,style:e[l]})));for(let r of i){let{state:o,spare:a,body:l,z:c}=r;nd(o,c,s,a),pd(a,o,l,s),[r.state,r.spare]=[a,o]}}var tg=.1,Ic=class{constructor(t,e,n,{style:s,radius:r,angle:o,way:a,speed:l}){let c=n.length/t.styles.length,h=[Math.sin(o),Math.cos(o)];Object.assign(this,{radius:r,way:a,speed:l,style:n.slice(c*s,c*(s+1))}),this.character=new ts(t,e),this.character.state=Mr(this.character.state,h.map(d=>r*d),[a*h[1],-a*h[0]])}command(){let{history:t}=this.character.state,[e,n]=t.slice(-4),s=Math.hypot(e,n)||1,{way:r}=this,o=(this.radius-s)/s,a=ue([r*n/s+o*e,-r*e/s+o*n]);return{velocity:a.map(l=>this.speed*l),facing:a}}},wr=class{constructor(t={}){Object.assign(this,{traits:t,listeners:{}})}get(t){return this.traits[t]}set(t,e){this.traits[t]=e,this.emit(`change:${t}`)}save_changes(){}on(t,e){(this.listeners[t]??=new Set).add(e)}off(t,e){this.listeners[t]?.delete(e)}emit(t,...e){for(let n of this.listeners[t]??[])n(...e)}},Yo=class extends wr{constructor(t){super();let{styles:e,labels:n,vectors:s,rules:r,start:o}=t;Object.assign(this,{data:t,fps:r.fps,character:new ts(t),vectors:qn(s)}),this.others=t.others.map(l=>new Ic(t,this.character.network,this.vectors,l)),this.size=this.vectors.length/e.length;let a=t.crowd&&{skeleton:t.crowd,tints:t.others.map(({tint:l})=>l)};this.traits={styles:e,labels:n,skeleton:t.skeleton,gate:t.gate,crowd:a,feet:!0,arms:!0,recording:!1,status:"",...t.traits},this.input={id:0,move:[0,0],turn:0,run:!1,heading:null},this.facing=Math.atan2(...o.facing),this.style=this.target(),this.frame=this.due=this.last=this.handle=0,[this.recorded,this.passed]=[[],[]],this.life=[this.style,...this.others.map(({style:l})=>l)].map((l,c)=>new bs(t.life.amount,t.life.period,c))}set(t,e){t==="recording"&&(e?this.recorded=[]:this.download?.(this.bvh()));let n=this.natural();super.set(t,e),["names","weights"].includes(t)&&this.traits.speed===n&&super.set("speed",this.natural())}natural(){let{names:t,weights:e,styles:n}=this.traits;return t.reduce((s,r,o)=>s+e[o]*this.data.speeds[n.indexOf(r)],0)}send(t){t.kind==="input"&&(this.input=t),t.kind==="closed"&&cancelAnimationFrame(this.handle)}target(){let{names:t,weights:e,styles:n}=this.traits,s=new Float64Array(this.size);return t.forEach((r,o)=>{let a=this.size*n.indexOf(r);for(let l=0;l<this.size;l++)s[l]+=e[o]*this.vectors[a+l]}),s}command(){let{move:[t,e],turn:n,run:s,heading:r}=this.input,{data:o,traits:a}=this,l=a.speed*(s?o.run:1);if(r)return this.facing=Math.atan2(...r),{velocity:r.map(u=>l*u),facing:r};this.facing+=o.turn/this.fps*n;let c=Math.sin(this.facing),h=Math.cos(this.facing),d=l/Math.max(1,Math.hypot(t,e));return{velocity:[d*(e*c-t*h),d*(e*h+t*c)],facing:[c,h]}}step(){let{style:t,character:e,data:n,traits:s}=this,r=this.target();for(let l=0;l<t.length;l++)t[l]+=n.ease*(r[l]-t[l]);let o=this.others.map(l=>l.character),a=[t,...this.others.map(l=>l.style)].map((l,c)=>this.life[c].at(this.frame,l));Es([e,...o],[this.command(),...this.others.map(l=>l.command())],a),this.frame+=1,!(!s.recording&&!n.gate?.roles)&&(e.pose(s),this.passed.push([e.root.slice(),e.rotations.slice()]),s.recording&&this.recorded.push(this.passed.at(-1)))}show(){let{character:t,character:{state:e,rules:n}}=this;t.pose(this.traits);let s=n.samples.slice(0,n.samples.length-n.position_shares.length),r=[t.root,t.rotations,...s.map(a=>e.history.subarray(4*a,4*a+4)),e.future,e.contacts,e.phase],o=Float32Array.from(r.flatMap(a=>[...a]));for(let{character:a}of this.others)a.pose(this.traits);this.others.length&&this.emit("msg:custom",{kind:"others"},[this.others.map(({character:{root:a,rotations:l}})=>[a,l])]),this.emit("msg:custom",{kind:"frame",frame:this.frame,input:this.input.id,passed:this.passed.splice(0)},[o])}run(){let t=e=>{this.handle=requestAnimationFrame(t),this.due+=this.fps*Math.min((e-(this.last||e))/1e3,tg),this.last=e;let n=Math.round(this.due);this.due-=n;try{for(let s=0;s<n;s++)this.step();n&&this.show()}catch(s){throw cancelAnimationFrame(this.handle),this.set("status",`stopped: ${s}`),s}};this.handle=requestAnimationFrame(t)}bvh(){return Lc(this.data.bvh,this.recorded,this.fps)}};function Lc({header:i,joints:t,centimetre:e},n,s){let r=Math.PI/180,o=l=>l.toFixed(6),a=n.map(([l,c])=>{let h=Array.from(l,d=>d/e);for(let d of t){let[u,f,m,v]=c.subarray(4*d,4*d+4),p=Math.min(Math.max(2*(u*f-m*v),-1),1),g=[Math.atan2(2*(u*m+f*v),1-2*(f*f+m*m)),Math.asin(p),Math.atan2(2*(u*v+f*m),1-2*(f*f+v*v))];h.push(...g.map(x=>x/r))}return h.map(o).join(" ")});return[`${i}MOTION`,`Frames: ${a.length}`,`Frame Time: ${(1/s).toFixed(8)}`,...a,""].join(`
`)}var zi={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Gi={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Zd=0,dh=1,Jd=2;var hs=1,Kd=2,nr=3,Jn=0,un=1,Ie=2,us=0,ir=1,fh=2,ph=3,mh=4,jd=5;var ds=100,Qd=101,tf=102,ef=103,nf=104,sf=200,rf=201,of=202,af=203,gh=204,_h=205,lf=206,cf=207,hf=208,uf=209,df=210,ff=211,pf=212,mf=213,gf=214,va=0,Ma=1,Sa=2,Hs=3,ba=4,wa=5,Ea=6,Aa=7,xh=0,_f=1,xf=2,Kn=0,yh=1,vh=2,Mh=3,Sh=4,bh=5,wh=6,Eh=7;var Ah=300,fs=301,sr=302,tl=303,el=304,Vs=1e3,Yn=1001,Ta=1002,Xe=1003,yf=1004;var xo=1005;var ln=1006,nl=1007;var _i=1008;var pn=1009,Th=1010,Rh=1011,rr=1012,il=1013,Gn=1014,mn=1015,Hn=1016,sl=1017,rl=1018,ps=1020,Ch=35902,Ph=35899,Ih=1021,Lh=1022,An=1023,fi=1026,xi=1027,ol=1028,al=1029,Hi=1030,ll=1031;var cl=1033,yo=33776,vo=33777,Mo=33778,So=33779,hl=35840,ul=35841,dl=35842,fl=35843,pl=36196,ml=37492,gl=37496,_l=37488,xl=37489,bo=37490,yl=37491,vl=37808,Ml=37809,Sl=37810,bl=37811,wl=37812,El=37813,Al=37814,Tl=37815,Rl=37816,Cl=37817,Pl=37818,Il=37819,Ll=37820,Dl=37821,Nl=36492,Ul=36494,Ol=36495,Fl=36283,Bl=36284,wo=36285,kl=36286;var Fr=2300,Ra=2301,xa=2302,nh=2303,ih=2400,sh=2401,rh=2402;var vf=3200;var zl=0,Mf=1,yi="",on="srgb",os="srgb-linear",Br="linear",me="srgb";var ya=7680;var Sf=519,bf=512,wf=513,Ef=514,Dh=515,Af=516,Tf=517,Nh=518,Uh=519,Rf=35044,Oh=35048;var Eo="300 es",Pn=2e3,Ws=2001;function eg(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function ng(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function kr(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Cf(){let i=kr("canvas");return i.style.display="block",i}var gd={},Xs=null;function Fh(...i){let t="THREE."+i.shift();Xs?Xs("log",t,...i):console.log(t,...i)}function Pf(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Gt(...i){i=Pf(i);let t="THREE."+i.shift();if(Xs)Xs("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Wt(...i){i=Pf(i);let t="THREE."+i.shift();if(Xs)Xs("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Lr(...i){let t=i.join(" ");t in gd||(gd[t]=!0,Gt(...i))}function If(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Lf={[va]:va,[Sa]:Ea,[ba]:ba,[Hs]:wa,[Ma]:Ma,[Ea]:Sa,[Aa]:Aa,[wa]:Hs},zn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Qe=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],_d=1234567,Dr=Math.PI/180,qs=180/Math.PI;function ms(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Qe[i&255]+Qe[i>>8&255]+Qe[i>>16&255]+Qe[i>>24&255]+"-"+Qe[t&255]+Qe[t>>8&255]+"-"+Qe[t>>16&15|64]+Qe[t>>24&255]+"-"+Qe[e&63|128]+Qe[e>>8&255]+"-"+Qe[e>>16&255]+Qe[e>>24&255]+Qe[n&255]+Qe[n>>8&255]+Qe[n>>16&255]+Qe[n>>24&255]).toLowerCase()}function ee(i,t,e){return Math.max(t,Math.min(e,i))}function Bh(i,t){return(i%t+t)%t}function ig(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function sg(i,t,e){return i!==t?(e-i)/(t-i):0}function Nr(i,t,e){return(1-e)*i+e*t}function rg(i,t,e,n){return Nr(i,t,1-Math.exp(-e*n))}function og(i,t=1){return t-Math.abs(Bh(i,t*2)-t)}function ag(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function lg(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function cg(i,t){return i+Math.floor(Math.random()*(t-i+1))}function hg(i,t){return i+Math.random()*(t-i)}function ug(i){return i*(.5-Math.random())}function dg(i){i!==void 0&&(_d=i);let t=_d+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function fg(i){return i*Dr}function pg(i){return i*qs}function mg(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function gg(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function kh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function _g(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),d=r((t-n)/2),u=o((t-n)/2),f=r((n-t)/2),m=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*d,l*u,a*c);break;case"YZY":i.set(l*u,a*h,l*d,a*c);break;case"ZXZ":i.set(l*d,l*u,a*h,a*c);break;case"XZX":i.set(a*h,l*m,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*m,a*c);break;case"ZYZ":i.set(l*m,l*f,a*h,a*c);break;default:Gt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function zh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Df(i,t){if(t.constructor===Float32Array)return i;let e=zh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Nf(i,t){if(t.constructor===Float32Array)return i;let e=zh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var Gh={DEG2RAD:Dr,RAD2DEG:qs,generateUUID:ms,clamp:ee,euclideanModulo:Bh,mapLinear:ig,inverseLerp:sg,lerp:Nr,damp:rg,pingpong:og,smoothstep:ag,smootherstep:lg,randInt:cg,randFloat:hg,randFloatSpread:ug,seededRandom:dg,degToRad:fg,radToDeg:pg,isPowerOfTwo:mg,ceilPowerOfTwo:gg,floorPowerOfTwo:kh,setQuaternionFromProperEuler:_g,normalize:Nf,denormalize:Df},bt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ee(this.x,t.x,e.x),this.y=ee(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ee(this.x,t,e),this.y=ee(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ee(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ee(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Sn=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[o+0],f=r[o+1],m=r[o+2],v=r[o+3];if(d!==v||l!==u||c!==f||h!==m){let p=l*u+c*f+h*m+d*v;p<0&&(u=-u,f=-f,m=-m,v=-v,p=-p);let g=1-a;if(p<.9995){let x=Math.acos(p),b=Math.sin(x);g=Math.sin(g*x)/b,a=Math.sin(a*x)/b,l=l*g+u*a,c=c*g+f*a,h=h*g+m*a,d=d*g+v*a}else{l=l*g+u*a,c=c*g+f*a,h=h*g+m*a,d=d*g+v*a;let x=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=x,c*=x,h*=x,d*=x}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[o],u=r[o+1],f=r[o+2],m=r[o+3];return t[e]=a*m+h*d+l*f-c*u,t[e+1]=l*m+h*u+c*d-a*f,t[e+2]=c*m+h*f+a*u-l*d,t[e+3]=h*m-a*d-l*u-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),d=a(r/2),u=l(n/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*f*m,this._y=c*f*d-u*h*m,this._z=c*h*m+u*f*d,this._w=c*h*d-u*f*m;break;case"YXZ":this._x=u*h*d+c*f*m,this._y=c*f*d-u*h*m,this._z=c*h*m-u*f*d,this._w=c*h*d+u*f*m;break;case"ZXY":this._x=u*h*d-c*f*m,this._y=c*f*d+u*h*m,this._z=c*h*m+u*f*d,this._w=c*h*d-u*f*m;break;case"ZYX":this._x=u*h*d-c*f*m,this._y=c*f*d+u*h*m,this._z=c*h*m-u*f*d,this._w=c*h*d+u*f*m;break;case"YZX":this._x=u*h*d+c*f*m,this._y=c*f*d+u*h*m,this._z=c*h*m-u*f*d,this._w=c*h*d-u*f*m;break;case"XZY":this._x=u*h*d-c*f*m,this._y=c*f*d-u*h*m,this._z=c*h*m+u*f*d,this._w=c*h*d+u*f*m;break;default:Gt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],d=e[10],u=n+a+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>d){let f=2*Math.sqrt(1+n-a-d);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-n-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ee(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},q=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(xd.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(xd.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),d=2*(r*n-o*e);return this.x=e+l*c+o*d-a*h,this.y=n+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ee(this.x,t.x,e.x),this.y=ee(this.y,t.y,e.y),this.z=ee(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ee(this.x,t,e),this.y=ee(this.y,t,e),this.z=ee(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ee(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Dc.copy(this).projectOnVector(t),this.sub(Dc)}reflect(t){return this.sub(Dc.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ee(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Dc=new q,xd=new Sn,qt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],f=n[5],m=n[8],v=s[0],p=s[3],g=s[6],x=s[1],b=s[4],M=s[7],E=s[2],S=s[5],_=s[8];return r[0]=o*v+a*x+l*E,r[3]=o*p+a*b+l*S,r[6]=o*g+a*M+l*_,r[1]=c*v+h*x+d*E,r[4]=c*p+h*b+d*S,r[7]=c*g+h*M+d*_,r[2]=u*v+f*x+m*E,r[5]=u*p+f*b+m*S,r[8]=u*g+f*M+m*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=h*o-a*c,u=a*l-h*r,f=c*r-o*l,m=e*d+n*u+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/m;return t[0]=d*v,t[1]=(s*c-h*n)*v,t[2]=(a*n-s*o)*v,t[3]=u*v,t[4]=(h*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=f*v,t[7]=(n*l-c*e)*v,t[8]=(o*e-n*r)*v,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Lr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Nc.makeScale(t,e)),this}rotate(t){return Lr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Nc.makeRotation(-t)),this}translate(t,e){return Lr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Nc.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Nc=new qt,yd=new qt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),vd=new qt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function xg(){let i={enabled:!0,workingColorSpace:os,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===me&&(s.r=di(s.r),s.g=di(s.g),s.b=di(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===me&&(s.r=zs(s.r),s.g=zs(s.g),s.b=zs(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===yi?Br:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[os]:{primaries:t,whitePoint:n,transfer:Br,toXYZ:yd,fromXYZ:vd,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:on},outputColorSpaceConfig:{drawingBufferColorSpace:on}},[on]:{primaries:t,whitePoint:n,transfer:me,toXYZ:yd,fromXYZ:vd,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:on}}}),i}var re=xg();function di(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function zs(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var As,Ca=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{As===void 0&&(As=kr("canvas")),As.width=t.width,As.height=t.height;let s=As.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=As}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=kr("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=di(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(di(e[n]/255)*255):e[n]=di(e[n]);return{data:e,width:t.width,height:t.height}}else return Gt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},yg=0,$s=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:yg++}),this.uuid=ms(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Uc(s[o].image)):r.push(Uc(s[o]))}else r=Uc(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function Uc(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Ca.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Gt("Texture: Unable to serialize Texture."),{})}var vg=0,Oc=new q,cn=class i extends zn{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=Yn,s=Yn,r=ln,o=_i,a=An,l=pn,c=i.DEFAULT_ANISOTROPY,h=yi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:vg++}),this.uuid=ms(),this.name="",this.source=new $s(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new bt(0,0),this.repeat=new bt(1,1),this.center=new bt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new qt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Oc).x}get height(){return this.source.getSize(Oc).y}get depth(){return this.source.getSize(Oc).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){Gt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Gt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Ah)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Vs:t.x=t.x-Math.floor(t.x);break;case Yn:t.x=t.x<0?0:1;break;case Ta:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Vs:t.y=t.y-Math.floor(t.y);break;case Yn:t.y=t.y<0?0:1;break;case Ta:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};cn.DEFAULT_IMAGE=null;cn.DEFAULT_MAPPING=Ah;cn.DEFAULT_ANISOTROPY=1;var be=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],m=l[9],v=l[2],p=l[6],g=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-v)<.01&&Math.abs(m-p)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+v)<.1&&Math.abs(m+p)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let b=(c+1)/2,M=(f+1)/2,E=(g+1)/2,S=(h+u)/4,_=(d+v)/4,y=(m+p)/4;return b>M&&b>E?b<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(b),s=S/n,r=_/n):M>E?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=S/s,r=y/s):E<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),n=_/r,s=y/r),this.set(n,s,r,e),this}let x=Math.sqrt((p-m)*(p-m)+(d-v)*(d-v)+(u-h)*(u-h));return Math.abs(x)<.001&&(x=1),this.x=(p-m)/x,this.y=(d-v)/x,this.z=(u-h)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ee(this.x,t.x,e.x),this.y=ee(this.y,t.y,e.y),this.z=ee(this.z,t.z,e.z),this.w=ee(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ee(this.x,t,e),this.y=ee(this.y,t,e),this.z=ee(this.z,t,e),this.w=ee(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ee(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Pa=class extends zn{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ln,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new be(0,0,t,e),this.scissorTest=!1,this.viewport=new be(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new cn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:ln,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new $s(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},bn=class extends Pa{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},zr=class extends cn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Xe,this.minFilter=Xe,this.wrapR=Yn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ia=class extends cn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Xe,this.minFilter=Xe,this.wrapR=Yn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ge=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,d,u,f,m,v,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,d,u,f,m,v,p)}set(t,e,n,s,r,o,a,l,c,h,d,u,f,m,v,p){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=d,g[14]=u,g[3]=f,g[7]=m,g[11]=v,g[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Ts.setFromMatrixColumn(t,0).length(),r=1/Ts.setFromMatrixColumn(t,1).length(),o=1/Ts.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*h,f=o*d,m=a*h,v=a*d;e[0]=l*h,e[4]=-l*d,e[8]=c,e[1]=f+m*c,e[5]=u-v*c,e[9]=-a*l,e[2]=v-u*c,e[6]=m+f*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*h,f=l*d,m=c*h,v=c*d;e[0]=u+v*a,e[4]=m*a-f,e[8]=o*c,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=f*a-m,e[6]=v+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*h,f=l*d,m=c*h,v=c*d;e[0]=u-v*a,e[4]=-o*d,e[8]=m+f*a,e[1]=f+m*a,e[5]=o*h,e[9]=v-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*h,f=o*d,m=a*h,v=a*d;e[0]=l*h,e[4]=m*c-f,e[8]=u*c+v,e[1]=l*d,e[5]=v*c+u,e[9]=f*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,f=o*c,m=a*l,v=a*c;e[0]=l*h,e[4]=v-u*d,e[8]=m*d+f,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*d+m,e[10]=u-v*d}else if(t.order==="XZY"){let u=o*l,f=o*c,m=a*l,v=a*c;e[0]=l*h,e[4]=-d,e[8]=c*h,e[1]=u*d+v,e[5]=o*h,e[9]=f*d-m,e[2]=m*d-f,e[6]=a*h,e[10]=v*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Mg,t,Sg)}lookAt(t,e,n){let s=this.elements;return yn.subVectors(t,e),yn.lengthSq()===0&&(yn.z=1),yn.normalize(),Ri.crossVectors(n,yn),Ri.lengthSq()===0&&(Math.abs(n.z)===1?yn.x+=1e-4:yn.z+=1e-4,yn.normalize(),Ri.crossVectors(n,yn)),Ri.normalize(),Zo.crossVectors(yn,Ri),s[0]=Ri.x,s[4]=Zo.x,s[8]=yn.x,s[1]=Ri.y,s[5]=Zo.y,s[9]=yn.y,s[2]=Ri.z,s[6]=Zo.z,s[10]=yn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],f=n[13],m=n[2],v=n[6],p=n[10],g=n[14],x=n[3],b=n[7],M=n[11],E=n[15],S=s[0],_=s[4],y=s[8],R=s[12],A=s[1],C=s[5],N=s[9],O=s[13],I=s[2],k=s[6],D=s[10],L=s[14],B=s[3],z=s[7],F=s[11],X=s[15];return r[0]=o*S+a*A+l*I+c*B,r[4]=o*_+a*C+l*k+c*z,r[8]=o*y+a*N+l*D+c*F,r[12]=o*R+a*O+l*L+c*X,r[1]=h*S+d*A+u*I+f*B,r[5]=h*_+d*C+u*k+f*z,r[9]=h*y+d*N+u*D+f*F,r[13]=h*R+d*O+u*L+f*X,r[2]=m*S+v*A+p*I+g*B,r[6]=m*_+v*C+p*k+g*z,r[10]=m*y+v*N+p*D+g*F,r[14]=m*R+v*O+p*L+g*X,r[3]=x*S+b*A+M*I+E*B,r[7]=x*_+b*C+M*k+E*z,r[11]=x*y+b*N+M*D+E*F,r[15]=x*R+b*O+M*L+E*X,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],d=t[6],u=t[10],f=t[14],m=t[3],v=t[7],p=t[11],g=t[15],x=l*f-c*u,b=a*f-c*d,M=a*u-l*d,E=o*f-c*h,S=o*u-l*h,_=o*d-a*h;return e*(v*x-p*b+g*M)-n*(m*x-p*E+g*S)+s*(m*b-v*E+g*_)-r*(m*M-v*S+p*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=t[9],u=t[10],f=t[11],m=t[12],v=t[13],p=t[14],g=t[15],x=e*a-n*o,b=e*l-s*o,M=e*c-r*o,E=n*l-s*a,S=n*c-r*a,_=s*c-r*l,y=h*v-d*m,R=h*p-u*m,A=h*g-f*m,C=d*p-u*v,N=d*g-f*v,O=u*g-f*p,I=x*O-b*N+M*C+E*A-S*R+_*y;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let k=1/I;return t[0]=(a*O-l*N+c*C)*k,t[1]=(s*N-n*O-r*C)*k,t[2]=(v*_-p*S+g*E)*k,t[3]=(u*S-d*_-f*E)*k,t[4]=(l*A-o*O-c*R)*k,t[5]=(e*O-s*A+r*R)*k,t[6]=(p*M-m*_-g*b)*k,t[7]=(h*_-u*M+f*b)*k,t[8]=(o*N-a*A+c*y)*k,t[9]=(n*A-e*N-r*y)*k,t[10]=(m*S-v*M+g*x)*k,t[11]=(d*M-h*S-f*x)*k,t[12]=(a*R-o*C-l*y)*k,t[13]=(e*C-n*R+s*y)*k,t[14]=(v*b-m*E-p*x)*k,t[15]=(h*E-d*b+u*x)*k,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,d=a+a,u=r*c,f=r*h,m=r*d,v=o*h,p=o*d,g=a*d,x=l*c,b=l*h,M=l*d,E=n.x,S=n.y,_=n.z;return s[0]=(1-(v+g))*E,s[1]=(f+M)*E,s[2]=(m-b)*E,s[3]=0,s[4]=(f-M)*S,s[5]=(1-(u+g))*S,s[6]=(p+x)*S,s[7]=0,s[8]=(m+b)*_,s[9]=(p-x)*_,s[10]=(1-(u+v))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Ts.set(s[0],s[1],s[2]).length(),a=Ts.set(s[4],s[5],s[6]).length(),l=Ts.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Fn.copy(this);let c=1/o,h=1/a,d=1/l;return Fn.elements[0]*=c,Fn.elements[1]*=c,Fn.elements[2]*=c,Fn.elements[4]*=h,Fn.elements[5]*=h,Fn.elements[6]*=h,Fn.elements[8]*=d,Fn.elements[9]*=d,Fn.elements[10]*=d,e.setFromRotationMatrix(Fn),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=Pn,l=!1){let c=this.elements,h=2*r/(e-t),d=2*r/(n-s),u=(e+t)/(e-t),f=(n+s)/(n-s),m,v;if(l)m=r/(o-r),v=o*r/(o-r);else if(a===Pn)m=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Ws)m=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Pn,l=!1){let c=this.elements,h=2/(e-t),d=2/(n-s),u=-(e+t)/(e-t),f=-(n+s)/(n-s),m,v;if(l)m=1/(o-r),v=o/(o-r);else if(a===Pn)m=-2/(o-r),v=-(o+r)/(o-r);else if(a===Ws)m=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Ts=new q,Fn=new ge,Mg=new q(0,0,0),Sg=new q(1,1,1),Ri=new q,Zo=new q,yn=new q,Md=new ge,Sd=new Sn,pi=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ee(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ee(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ee(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ee(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ee(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ee(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Gt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Md.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Md,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Sd.setFromEuler(this),this.setFromQuaternion(Sd,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};pi.DEFAULT_ORDER="XYZ";var Gr=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},bg=0,bd=new q,Rs=new Sn,ai=new ge,Jo=new q,Er=new q,wg=new q,Eg=new Sn,wd=new q(1,0,0),Ed=new q(0,1,0),Ad=new q(0,0,1),Td={type:"added"},Ag={type:"removed"},Cs={type:"childadded",child:null},Fc={type:"childremoved",child:null},en=class i extends zn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:bg++}),this.uuid=ms(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new q,e=new pi,n=new Sn,s=new q(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ge},normalMatrix:{value:new qt}}),this.matrix=new ge,this.matrixWorld=new ge,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Gr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Rs.setFromAxisAngle(t,e),this.quaternion.multiply(Rs),this}rotateOnWorldAxis(t,e){return Rs.setFromAxisAngle(t,e),this.quaternion.premultiply(Rs),this}rotateX(t){return this.rotateOnAxis(wd,t)}rotateY(t){return this.rotateOnAxis(Ed,t)}rotateZ(t){return this.rotateOnAxis(Ad,t)}translateOnAxis(t,e){return bd.copy(t).applyQuaternion(this.quaternion),this.position.add(bd.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(wd,t)}translateY(t){return this.translateOnAxis(Ed,t)}translateZ(t){return this.translateOnAxis(Ad,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ai.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Jo.copy(t):Jo.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Er.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ai.lookAt(Er,Jo,this.up):ai.lookAt(Jo,Er,this.up),this.quaternion.setFromRotationMatrix(ai),s&&(ai.extractRotation(s.matrixWorld),Rs.setFromRotationMatrix(ai),this.quaternion.premultiply(Rs.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Wt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Td),Cs.child=t,this.dispatchEvent(Cs),Cs.child=null):Wt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Ag),Fc.child=t,this.dispatchEvent(Fc),Fc.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ai.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ai.multiply(t.parent.matrixWorld)),t.applyMatrix4(ai),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Td),Cs.child=t,this.dispatchEvent(Cs),Cs.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Er,t,wg),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Er,Eg,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),f=o(t.animations),m=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};en.DEFAULT_UP=new q(0,1,0);en.DEFAULT_MATRIX_AUTO_UPDATE=!0;en.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var rs=class extends en{constructor(){super(),this.isGroup=!0,this.type="Group"}},Tg={type:"move"},Ys=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new rs,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new rs,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new rs,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let v of t.hand.values()){let p=e.getJointPose(v,n),g=this._getHandJoint(c,v);p!==null&&(g.matrix.fromArray(p.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=p.radius),g.visible=p!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,m=.005;c.inputState.pinching&&u>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Tg)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new rs;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},Uf={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ci={h:0,s:0,l:0},Ko={h:0,s:0,l:0};function Bc(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var Yt=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=on){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,re.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=re.workingColorSpace){return this.r=t,this.g=e,this.b=n,re.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=re.workingColorSpace){if(t=Bh(t,1),e=ee(e,0,1),n=ee(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Bc(o,r,t+1/3),this.g=Bc(o,r,t),this.b=Bc(o,r,t-1/3)}return re.colorSpaceToWorking(this,s),this}setStyle(t,e=on){function n(r){r!==void 0&&parseFloat(r)<1&&Gt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Gt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Gt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=on){let n=Uf[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Gt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=di(t.r),this.g=di(t.g),this.b=di(t.b),this}copyLinearToSRGB(t){return this.r=zs(t.r),this.g=zs(t.g),this.b=zs(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=on){return re.workingToColorSpace(tn.copy(this),t),Math.round(ee(tn.r*255,0,255))*65536+Math.round(ee(tn.g*255,0,255))*256+Math.round(ee(tn.b*255,0,255))}getHexString(t=on){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=re.workingColorSpace){re.workingToColorSpace(tn.copy(this),e);let n=tn.r,s=tn.g,r=tn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=re.workingColorSpace){return re.workingToColorSpace(tn.copy(this),e),t.r=tn.r,t.g=tn.g,t.b=tn.b,t}getStyle(t=on){re.workingToColorSpace(tn.copy(this),t);let e=tn.r,n=tn.g,s=tn.b;return t!==on?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Ci),this.setHSL(Ci.h+t,Ci.s+e,Ci.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Ci),t.getHSL(Ko);let n=Nr(Ci.h,Ko.h,e),s=Nr(Ci.s,Ko.s,e),r=Nr(Ci.l,Ko.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},tn=new Yt;Yt.NAMES=Uf;var Hr=class i{constructor(t,e=1,n=1e3){this.isFog=!0,this.name="",this.color=new Yt(t),this.near=e,this.far=n}clone(){return new i(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},Vr=class extends en{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new pi,this.environmentIntensity=1,this.environmentRotation=new pi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Bn=new q,li=new q,kc=new q,ci=new q,Ps=new q,Is=new q,Rd=new q,zc=new q,Gc=new q,Hc=new q,Vc=new be,Wc=new be,Xc=new be,Di=class i{constructor(t=new q,e=new q,n=new q){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Bn.subVectors(t,e),s.cross(Bn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Bn.subVectors(s,e),li.subVectors(n,e),kc.subVectors(t,e);let o=Bn.dot(Bn),a=Bn.dot(li),l=Bn.dot(kc),c=li.dot(li),h=li.dot(kc),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(c*l-a*h)*u,m=(o*h-a*l)*u;return r.set(1-f-m,m,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,ci)===null?!1:ci.x>=0&&ci.y>=0&&ci.x+ci.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,ci)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ci.x),l.addScaledVector(o,ci.y),l.addScaledVector(a,ci.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return Vc.setScalar(0),Wc.setScalar(0),Xc.setScalar(0),Vc.fromBufferAttribute(t,e),Wc.fromBufferAttribute(t,n),Xc.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Vc,r.x),o.addScaledVector(Wc,r.y),o.addScaledVector(Xc,r.z),o}static isFrontFacing(t,e,n,s){return Bn.subVectors(n,e),li.subVectors(t,e),Bn.cross(li).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Bn.subVectors(this.c,this.b),li.subVectors(this.a,this.b),Bn.cross(li).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Ps.subVectors(s,n),Is.subVectors(r,n),zc.subVectors(t,n);let l=Ps.dot(zc),c=Is.dot(zc);if(l<=0&&c<=0)return e.copy(n);Gc.subVectors(t,s);let h=Ps.dot(Gc),d=Is.dot(Gc);if(h>=0&&d<=h)return e.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(Ps,o);Hc.subVectors(t,r);let f=Ps.dot(Hc),m=Is.dot(Hc);if(m>=0&&f<=m)return e.copy(r);let v=f*c-l*m;if(v<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(n).addScaledVector(Is,a);let p=h*m-f*d;if(p<=0&&d-h>=0&&f-m>=0)return Rd.subVectors(r,s),a=(d-h)/(d-h+(f-m)),e.copy(s).addScaledVector(Rd,a);let g=1/(p+v+u);return o=v*g,a=u*g,e.copy(n).addScaledVector(Ps,o).addScaledVector(Is,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Zn=class{constructor(t=new q(1/0,1/0,1/0),e=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(kn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(kn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=kn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,kn):kn.fromBufferAttribute(r,o),kn.applyMatrix4(t.matrixWorld),this.expandByPoint(kn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),jo.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),jo.copy(n.boundingBox)),jo.applyMatrix4(t.matrixWorld),this.union(jo)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,kn),kn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ar),Qo.subVectors(this.max,Ar),Ls.subVectors(t.a,Ar),Ds.subVectors(t.b,Ar),Ns.subVectors(t.c,Ar),Pi.subVectors(Ds,Ls),Ii.subVectors(Ns,Ds),es.subVectors(Ls,Ns);let e=[0,-Pi.z,Pi.y,0,-Ii.z,Ii.y,0,-es.z,es.y,Pi.z,0,-Pi.x,Ii.z,0,-Ii.x,es.z,0,-es.x,-Pi.y,Pi.x,0,-Ii.y,Ii.x,0,-es.y,es.x,0];return!qc(e,Ls,Ds,Ns,Qo)||(e=[1,0,0,0,1,0,0,0,1],!qc(e,Ls,Ds,Ns,Qo))?!1:(ta.crossVectors(Pi,Ii),e=[ta.x,ta.y,ta.z],qc(e,Ls,Ds,Ns,Qo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,kn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(kn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(hi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),hi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),hi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),hi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),hi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),hi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),hi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),hi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(hi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},hi=[new q,new q,new q,new q,new q,new q,new q,new q],kn=new q,jo=new Zn,Ls=new q,Ds=new q,Ns=new q,Pi=new q,Ii=new q,es=new q,Ar=new q,Qo=new q,ta=new q,ns=new q;function qc(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){ns.fromArray(i,r);let a=s.x*Math.abs(ns.x)+s.y*Math.abs(ns.y)+s.z*Math.abs(ns.z),l=t.dot(ns),c=e.dot(ns),h=n.dot(ns);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Pe=new q,ea=new bt,Rg=0,Ue=class extends zn{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Rg++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Rf,this.updateRanges=[],this.gpuType=mn,this.version=0,this._normalizationScale=t!==void 0?zh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)ea.fromBufferAttribute(this,e),ea.applyMatrix3(t),this.setXY(e,ea.x,ea.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Pe.fromBufferAttribute(this,e),Pe.applyMatrix3(t),this.setXYZ(e,Pe.x,Pe.y,Pe.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Pe.fromBufferAttribute(this,e),Pe.applyMatrix4(t),this.setXYZ(e,Pe.x,Pe.y,Pe.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Pe.fromBufferAttribute(this,e),Pe.applyNormalMatrix(t),this.setXYZ(e,Pe.x,Pe.y,Pe.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Pe.fromBufferAttribute(this,e),Pe.transformDirection(t),this.setXYZ(e,Pe.x,Pe.y,Pe.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Df(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Nf(t,this.array)}};var Wr=class extends Ue{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Xr=class extends Ue{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Te=class extends Ue{constructor(t,e,n){super(new Float32Array(t),e,n)}},Cg=new Zn,Tr=new q,$c=new q,Ni=class{constructor(t=new q,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):Cg.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Tr.subVectors(t,this.center);let e=Tr.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Tr,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):($c.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Tr.copy(t.center).add($c)),this.expandByPoint(Tr.copy(t.center).sub($c))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Pg=0,Cn=new ge,Yc=new en,Us=new q,vn=new Zn,Rr=new Zn,We=new q,$e=class i extends zn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Pg++}),this.uuid=ms(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(eg(t)?Xr:Wr)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new qt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Cn.makeRotationFromQuaternion(t),this.applyMatrix4(Cn),this}rotateX(t){return Cn.makeRotationX(t),this.applyMatrix4(Cn),this}rotateY(t){return Cn.makeRotationY(t),this.applyMatrix4(Cn),this}rotateZ(t){return Cn.makeRotationZ(t),this.applyMatrix4(Cn),this}translate(t,e,n){return Cn.makeTranslation(t,e,n),this.applyMatrix4(Cn),this}scale(t,e,n){return Cn.makeScale(t,e,n),this.applyMatrix4(Cn),this}lookAt(t){return Yc.lookAt(t),Yc.updateMatrix(),this.applyMatrix4(Yc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Us).negate(),this.translate(Us.x,Us.y,Us.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Te(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Gt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Zn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Wt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];vn.setFromBufferAttribute(r),this.morphTargetsRelative?(We.addVectors(this.boundingBox.min,vn.min),this.boundingBox.expandByPoint(We),We.addVectors(this.boundingBox.max,vn.max),this.boundingBox.expandByPoint(We)):(this.boundingBox.expandByPoint(vn.min),this.boundingBox.expandByPoint(vn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Wt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ni);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Wt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(t){let n=this.boundingSphere.center;if(vn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Rr.setFromBufferAttribute(a),this.morphTargetsRelative?(We.addVectors(vn.min,Rr.min),vn.expandByPoint(We),We.addVectors(vn.max,Rr.max),vn.expandByPoint(We)):(vn.expandByPoint(Rr.min),vn.expandByPoint(Rr.max))}vn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)We.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(We));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)We.fromBufferAttribute(a,c),l&&(Us.fromBufferAttribute(t,c),We.add(Us)),s=Math.max(s,n.distanceToSquared(We))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Wt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Wt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Ue(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let R=0;R<n.count;R++)a[R]=new q,l[R]=new q;let h=new q,d=new q,u=new q,f=new bt,m=new bt,v=new bt,p=new q,g=new q;function x(R,A,C){c[R]=c[A]=c[C]=1,h.fromBufferAttribute(n,R),d.fromBufferAttribute(n,A),u.fromBufferAttribute(n,C),f.fromBufferAttribute(r,R),m.fromBufferAttribute(r,A),v.fromBufferAttribute(r,C),d.sub(h),u.sub(h),m.sub(f),v.sub(f);let N=1/(m.x*v.y-v.x*m.y);isFinite(N)&&(p.copy(d).multiplyScalar(v.y).addScaledVector(u,-m.y).multiplyScalar(N),g.copy(u).multiplyScalar(m.x).addScaledVector(d,-v.x).multiplyScalar(N),a[R].add(p),a[A].add(p),a[C].add(p),l[R].add(g),l[A].add(g),l[C].add(g))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let R=0,A=b.length;R<A;++R){let C=b[R],N=C.start,O=C.count;for(let I=N,k=N+O;I<k;I+=3)x(t.getX(I+0),t.getX(I+1),t.getX(I+2))}let M=new q,E=new q,S=new q,_=new q;function y(R){S.fromBufferAttribute(s,R),_.copy(S);let A=a[R];M.copy(A),M.sub(S.multiplyScalar(S.dot(A))).normalize(),E.crossVectors(_,A);let N=E.dot(l[R])<0?-1:1;o.setXYZW(R,M.x,M.y,M.z,N)}for(let R=0,A=n.count;R<A;++R)c[R]&&y(R);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Ue(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);let s=new q,r=new q,o=new q,a=new q,l=new q,c=new q,h=new q,d=new q;if(t)for(let u=0,f=t.count;u<f;u+=3){let m=t.getX(u+0),v=t.getX(u+1),p=t.getX(u+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,p),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let u=0,f=e.count;u<f;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)We.fromBufferAttribute(t,e),We.normalize(),t.setXYZ(e,We.x,We.y,We.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),f=0,m=0;for(let v=0,p=l.length;v<p;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*h;for(let g=0;g<h;g++)u[m++]=c[f++]}return new Ue(u,h,d)}if(this.index===null)return Gt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=t(u,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Zc=new q,Ig=new q,Lg=new qt,Mn=class{constructor(t=new q(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Zc.subVectors(n,e).cross(Ig.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Zc),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Lg.getNormalMatrix(t),s=this.coplanarPoint(Zc).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Dg=0,mi=class extends zn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Dg++}),this.uuid=ms(),this.name="",this.type="Material",this.blending=ir,this.side=Jn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=gh,this.blendDst=_h,this.blendEquation=ds,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Yt(0,0,0),this.blendAlpha=0,this.depthFunc=Hs,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Sf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ya,this.stencilZFail=ya,this.stencilZPass=ya,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){Gt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Gt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Yt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new Mn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new bt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new bt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var ui=new q,Jc=new q,na=new q,ia=new q,Zs=class{constructor(t=new q,e=new q(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,ui)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=ui.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(ui.copy(this.origin).addScaledVector(this.direction,e),ui.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Jc.copy(t).add(e).multiplyScalar(.5),na.copy(e).sub(t).normalize(),ia.copy(this.origin).sub(Jc);let r=t.distanceTo(e)*.5,o=-this.direction.dot(na),a=ia.dot(this.direction),l=-ia.dot(na),c=ia.lengthSq(),h=Math.abs(1-o*o),d,u,f,m;if(h>0)if(d=o*l-a,u=o*a-l,m=r*h,d>=0)if(u>=-m)if(u<=m){let v=1/h;d*=v,u*=v,f=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u<=-m?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=m?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Jc).addScaledVector(na,u),f}intersectSphere(t,e){if(t.radius<0)return null;ui.subVectors(t.center,this.origin);let n=ui.dot(this.direction),s=ui.dot(ui)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(n=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,l=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,l=(t.min.z-u.z)*d),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,ui)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=t.x-o.x,u=t.y-o.y,f=t.z-o.z,m=e.x-o.x,v=e.y-o.y,p=e.z-o.z,g=n.x-o.x,x=n.y-o.y,b=n.z-o.z,M=Math.abs(l),E=Math.abs(c),S=Math.abs(h),_,y,R,A,C,N,O,I,k,D,L,B;if(M>=E&&M>=S?(R=l,N=d,k=m,B=g,l>=0?(_=c,y=h,A=u,C=f,O=v,I=p,D=x,L=b):(_=h,y=c,A=f,C=u,O=p,I=v,D=b,L=x)):E>=S?(R=c,N=u,k=v,B=x,c>=0?(_=h,y=l,A=f,C=d,O=p,I=m,D=b,L=g):(_=l,y=h,A=d,C=f,O=m,I=p,D=g,L=b)):(R=h,N=f,k=p,B=b,h>=0?(_=l,y=c,A=d,C=u,O=m,I=v,D=g,L=x):(_=c,y=l,A=u,C=d,O=v,I=m,D=x,L=g)),R===0)return null;let z=_/R,F=y/R,X=1/R,et=A-z*N,W=C-F*N,U=O-z*k,Q=I-F*k,K=D-z*B,at=L-F*B,ot=K*Q-at*U,It=et*at-W*K,Xt=U*W-Q*et;if(s){if(ot<0||It<0||Xt<0)return null}else if((ot<0||It<0||Xt<0)&&(ot>0||It>0||Xt>0))return null;let Ct=ot+It+Xt;if(Ct===0)return null;let Kt=X*(ot*N+It*k+Xt*B);return(Ct>0?Kt<0:Kt>0)?null:this.at(Kt/Ct,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},hn=class extends mi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Yt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new pi,this.combine=xh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Cd=new ge,is=new Zs,sa=new Ni,Pd=new q,ra=new q,oa=new q,aa=new q,Kc=new q,la=new q,Id=new q,ca=new q,we=class extends en{constructor(t=new $e,e=new hn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){la.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(Kc.fromBufferAttribute(d,t),o?la.addScaledVector(Kc,h):la.addScaledVector(Kc.sub(e),h))}e.add(la)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),sa.copy(n.boundingSphere),sa.applyMatrix4(r),is.copy(t.ray).recast(t.near),!(sa.containsPoint(is.origin)===!1&&(is.intersectSphere(sa,Pd)===null||is.origin.distanceToSquared(Pd)>(t.far-t.near)**2))&&(Cd.copy(r).invert(),is.copy(t.ray).applyMatrix4(Cd),!(n.boundingBox!==null&&is.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,is)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,v=u.length;m<v;m++){let p=u[m],g=o[p.materialIndex],x=Math.max(p.start,f.start),b=Math.min(a.count,Math.min(p.start+p.count,f.start+f.count));for(let M=x,E=b;M<E;M+=3){let S=a.getX(M),_=a.getX(M+1),y=a.getX(M+2);s=ha(this,g,t,n,c,h,d,S,_,y),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let p=m,g=v;p<g;p+=3){let x=a.getX(p),b=a.getX(p+1),M=a.getX(p+2);s=ha(this,o,t,n,c,h,d,x,b,M),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,v=u.length;m<v;m++){let p=u[m],g=o[p.materialIndex],x=Math.max(p.start,f.start),b=Math.min(l.count,Math.min(p.start+p.count,f.start+f.count));for(let M=x,E=b;M<E;M+=3){let S=M,_=M+1,y=M+2;s=ha(this,g,t,n,c,h,d,S,_,y),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let p=m,g=v;p<g;p+=3){let x=p,b=p+1,M=p+2;s=ha(this,o,t,n,c,h,d,x,b,M),s&&(s.faceIndex=Math.floor(p/3),e.push(s))}}}};function Ng(i,t,e,n,s,r,o,a){let l;if(t.side===un?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===Jn,a),l===null)return null;ca.copy(a),ca.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(ca);return c<e.near||c>e.far?null:{distance:c,point:ca.clone(),object:i}}function ha(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,ra),i.getVertexPosition(l,oa),i.getVertexPosition(c,aa);let h=Ng(i,t,e,n,ra,oa,aa,Id);if(h){let d=new q;Di.getBarycoord(Id,ra,oa,aa,d),s&&(h.uv=Di.getInterpolatedAttribute(s,a,l,c,d,new bt)),r&&(h.uv1=Di.getInterpolatedAttribute(r,a,l,c,d,new bt)),o&&(h.normal=Di.getInterpolatedAttribute(o,a,l,c,d,new q),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new q,materialIndex:0};Di.getNormal(ra,oa,aa,u.normal),h.face=u,h.barycoord=d}return h}var as=class extends cn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Xe,h=Xe,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ls=class extends Ue{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Os=new ge,Ld=new ge,ua=[],Dd=new Zn,Ug=new ge,Cr=new we,Pr=new Ni,qr=class extends we{constructor(t,e,n){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new ls(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Ug)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Zn),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,Os),Dd.copy(t.boundingBox).applyMatrix4(Os),this.boundingBox.union(Dd)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ni),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,Os),Pr.copy(t.boundingSphere).applyMatrix4(Os),this.boundingSphere.union(Pr)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(t,e){let n=this.matrixWorld,s=this.count;if(Cr.geometry=this.geometry,Cr.material=this.material,Cr.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Pr.copy(this.boundingSphere),Pr.applyMatrix4(n),t.ray.intersectsSphere(Pr)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Os),Ld.multiplyMatrices(n,Os),Cr.matrixWorld=Ld,Cr.raycast(t,ua);for(let o=0,a=ua.length;o<a;o++){let l=ua[o];l.instanceId=r,l.object=this,e.push(l)}ua.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new ls(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let n=e.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new as(new Float32Array(s*this.count),s,this.count,ol,mn));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},ss=new Ni,Og=new bt(.5,.5),da=new q,Ui=class{constructor(t=new Mn,e=new Mn,n=new Mn,s=new Mn,r=new Mn,o=new Mn){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Pn,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],f=r[7],m=r[8],v=r[9],p=r[10],g=r[11],x=r[12],b=r[13],M=r[14],E=r[15];if(s[0].setComponents(c-o,f-h,g-m,E-x).normalize(),s[1].setComponents(c+o,f+h,g+m,E+x).normalize(),s[2].setComponents(c+a,f+d,g+v,E+b).normalize(),s[3].setComponents(c-a,f-d,g-v,E-b).normalize(),n)s[4].setComponents(l,u,p,M).normalize(),s[5].setComponents(c-l,f-u,g-p,E-M).normalize();else if(s[4].setComponents(c-l,f-u,g-p,E-M).normalize(),e===Pn)s[5].setComponents(c+l,f+u,g+p,E+M).normalize();else if(e===Ws)s[5].setComponents(l,u,p,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),ss.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),ss.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(ss)}intersectsSprite(t){ss.center.set(0,0,0);let e=Og.distanceTo(t.center);return ss.radius=.7071067811865476+e,ss.applyMatrix4(t.matrixWorld),this.intersectsSphere(ss)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(da.x=s.normal.x>0?t.max.x:t.min.x,da.y=s.normal.y>0?t.max.y:t.min.y,da.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(da)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Nd=new ge,La=class i{constructor(){this.coordinateSystem=Pn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Nd.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Ui),n[s].setFromProjectionMatrix(Nd,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Ui),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var $r=class extends cn{constructor(t=[],e=fs,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Yr=class extends cn{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}};var gi=class extends cn{constructor(t,e,n=Gn,s,r,o,a=Xe,l=Xe,c,h=fi,d=1){if(h!==fi&&h!==xi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:d};super(u,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new $s(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Zr=class extends gi{constructor(t,e=Gn,n=fs,s,r,o=Xe,a=Xe,l,c=fi){let h={width:t,height:t,depth:1},d=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Jr=class extends cn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Js=class i extends $e{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,f=0;m("z","y","x",-1,-1,n,e,t,o,r,0),m("z","y","x",1,-1,n,e,-t,o,r,1),m("x","z","y",1,1,t,n,e,s,o,2),m("x","z","y",1,-1,t,n,-e,s,o,3),m("x","y","z",1,-1,t,e,n,s,r,4),m("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Te(c,3)),this.setAttribute("normal",new Te(h,3)),this.setAttribute("uv",new Te(d,2));function m(v,p,g,x,b,M,E,S,_,y,R){let A=M/_,C=E/y,N=M/2,O=E/2,I=S/2,k=_+1,D=y+1,L=0,B=0,z=new q;for(let F=0;F<D;F++){let X=F*C-O;for(let et=0;et<k;et++){let W=et*A-N;z[v]=W*x,z[p]=X*b,z[g]=I,c.push(z.x,z.y,z.z),z[v]=0,z[p]=0,z[g]=S>0?1:-1,h.push(z.x,z.y,z.z),d.push(et/_),d.push(1-F/y),L+=1}}for(let F=0;F<y;F++)for(let X=0;X<_;X++){let et=u+X+k*F,W=u+X+k*(F+1),U=u+(X+1)+k*(F+1),Q=u+(X+1)+k*F;l.push(et,W,Q),l.push(W,U,Q),B+=6}a.addGroup(f,B,R),f+=B,u+=L}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var wn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Gt("Curve: .getPoint() not implemented.")}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],u=n[s+1]-h,f=(o-h)/u;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new bt:new q);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){let n=new q,s=[],r=[],o=[],a=new q,l=new ge;for(let f=0;f<=t;f++){let m=f/t;s[f]=this.getTangentAt(m,new q)}r[0]=new q,o[0]=new q;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),d=Math.abs(s[0].y),u=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),d<=c&&(c=d,n.set(0,1,0)),u<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let m=Math.acos(ee(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,m))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(ee(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let m=1;m<=t;m++)r[m].applyMatrix4(l.makeRotationAxis(s[m],f*m)),o[m].crossVectors(s[m],r[m])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},Ks=class extends wn{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new bt){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),d=Math.sin(this.aRotation),u=l-this.aX,f=c-this.aY;l=u*h-f*d+this.aX,c=u*d+f*h+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},Da=class extends Ks{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function Hh(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,d){let u=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+d)+(l-a)/d;u*=h,f*=h,s(o,a,u,f)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var Ud=new q,Od=new q,jc=new Hh,Qc=new Hh,th=new Hh,Na=class extends wn{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new q){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(Od.subVectors(s[0],s[1]).add(s[0]),c=Od);let d=s[a%r],u=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(Ud.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=Ud),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,m=Math.pow(c.distanceToSquared(d),f),v=Math.pow(d.distanceToSquared(u),f),p=Math.pow(u.distanceToSquared(h),f);v<1e-4&&(v=1),m<1e-4&&(m=v),p<1e-4&&(p=v),jc.initNonuniformCatmullRom(c.x,d.x,u.x,h.x,m,v,p),Qc.initNonuniformCatmullRom(c.y,d.y,u.y,h.y,m,v,p),th.initNonuniformCatmullRom(c.z,d.z,u.z,h.z,m,v,p)}else this.curveType==="catmullrom"&&(jc.initCatmullRom(c.x,d.x,u.x,h.x,this.tension),Qc.initCatmullRom(c.y,d.y,u.y,h.y,this.tension),th.initCatmullRom(c.z,d.z,u.z,h.z,this.tension));return n.set(jc.calc(l),Qc.calc(l),th.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new q().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function Fd(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function Fg(i,t){let e=1-i;return e*e*t}function Bg(i,t){return 2*(1-i)*i*t}function kg(i,t){return i*i*t}function Ur(i,t,e,n){return Fg(i,t)+Bg(i,e)+kg(i,n)}function zg(i,t){let e=1-i;return e*e*e*t}function Gg(i,t){let e=1-i;return 3*e*e*i*t}function Hg(i,t){return 3*(1-i)*i*i*t}function Vg(i,t){return i*i*i*t}function Or(i,t,e,n,s){return zg(i,t)+Gg(i,e)+Hg(i,n)+Vg(i,s)}var Kr=class extends wn{constructor(t=new bt,e=new bt,n=new bt,s=new bt){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new bt){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Or(t,s.x,r.x,o.x,a.x),Or(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Ua=class extends wn{constructor(t=new q,e=new q,n=new q,s=new q){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new q){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Or(t,s.x,r.x,o.x,a.x),Or(t,s.y,r.y,o.y,a.y),Or(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},jr=class extends wn{constructor(t=new bt,e=new bt){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new bt){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new bt){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Oa=class extends wn{constructor(t=new q,e=new q){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new q){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new q){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Qr=class extends wn{constructor(t=new bt,e=new bt,n=new bt){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new bt){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(Ur(t,s.x,r.x,o.x),Ur(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Fa=class extends wn{constructor(t=new q,e=new q,n=new q){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new q){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(Ur(t,s.x,r.x,o.x),Ur(t,s.y,r.y,o.y),Ur(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},to=class extends wn{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new bt){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],d=s[o>s.length-3?s.length-1:o+2];return n.set(Fd(a,l.x,c.x,h.x,d.x),Fd(a,l.y,c.y,h.y,d.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new bt().fromArray(s))}return this}},Bd=Object.freeze({__proto__:null,ArcCurve:Da,CatmullRomCurve3:Na,CubicBezierCurve:Kr,CubicBezierCurve3:Ua,EllipseCurve:Ks,LineCurve:jr,LineCurve3:Oa,QuadraticBezierCurve:Qr,QuadraticBezierCurve3:Fa,SplineCurve:to}),Ba=class extends wn{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1,this.cacheLengths=null}add(t){this.curves.push(t)}closePath(){let t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){let n=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Bd[n](e,t))}return this}getPoint(t,e){let n=t*this.getLength(),s=this.getCurveLengths(),r=0;for(;r<s.length;){if(s[r]>=n){let o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,e)}r++}return null}getLength(){let t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;let t=[],e=0;for(let n=0,s=this.curves.length;n<s;n++)e+=this.curves[n].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){let e=[],n;for(let s=0,r=this.curves;s<r.length;s++){let o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,l=o.getPoints(a);for(let c=0;c<l.length;c++){let h=l[c];n&&n.equals(h)||(e.push(h),n=h)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this.cacheLengths=null,this}toJSON(){let t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,n=this.curves.length;e<n;e++){let s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){let s=t.curves[e];this.curves.push(new Bd[s.type]().fromJSON(s))}return this.cacheLengths=null,this}},eo=class extends Ba{constructor(t){super(),this.type="Path",this.currentPoint=new bt,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,n=t.length;e<n;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){let n=new jr(this.currentPoint.clone(),new bt(t,e));return this.curves.push(n),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,n,s){let r=new Qr(this.currentPoint.clone(),new bt(t,e),new bt(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(t,e,n,s,r,o){let a=new Kr(this.currentPoint.clone(),new bt(t,e),new bt(n,s),new bt(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){let e=[this.currentPoint.clone()].concat(t),n=new to(e);return this.curves.push(n),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,n,s,r,o){let a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+a,e+l,n,s,r,o),this}absarc(t,e,n,s,r,o){return this.absellipse(t,e,n,n,s,r,o),this}ellipse(t,e,n,s,r,o,a,l){let c=this.currentPoint.x,h=this.currentPoint.y;return this.absellipse(t+c,e+h,n,s,r,o,a,l),this}absellipse(t,e,n,s,r,o,a,l){let c=new Ks(t,e,n,s,r,o,a,l);if(this.curves.length>0){let d=c.getPoint(0);d.equals(this.currentPoint)||this.lineTo(d.x,d.y)}this.curves.push(c);let h=c.getPoint(1);return this.currentPoint.copy(h),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){let t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}},js=class extends eo{constructor(t){super(t),this.uuid=ms(),this.type="Shape",this.holes=[]}getPointsHoles(t){let e=[];for(let n=0,s=this.holes.length;n<s;n++)e[n]=this.holes[n].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,n=this.holes.length;e<n;e++){let s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){let s=t.holes[e];this.holes.push(new eo().fromJSON(s))}return this}};function Wg(i,t,e=2){let n=t&&t.length,s=n?t[0]*e:i.length,r=Of(i,0,s,e,!0),o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=Zg(i,t,r,e)),i.length>80*e){a=i[0],l=i[1];let h=a,d=l;for(let u=e;u<s;u+=e){let f=i[u],m=i[u+1];f<a&&(a=f),m<l&&(l=m),f>h&&(h=f),m>d&&(d=m)}c=Math.max(h-a,d-l),c=c!==0?32767/c:0}return no(r,o,e,a,l,c,0),o}function Of(i,t,e,n,s){let r;if(s===o0(i,t,e,n)>0)for(let o=t;o<e;o+=n)r=kd(o/n|0,i[o],i[o+1],r);else for(let o=e-n;o>=t;o-=n)r=kd(o/n|0,i[o],i[o+1],r);return r&&Qs(r,r.next)&&(so(r),r=r.next),r}function cs(i,t){if(!i)return i;t||(t=i);let e=i,n;do if(n=!1,!e.steiner&&(Qs(e,e.next)||Ae(e.prev,e,e.next)===0)){if(so(e),e=t=e.prev,e===e.next)break;n=!0}else e=e.next;while(n||e!==t);return t}function no(i,t,e,n,s,r,o){if(!i)return;!o&&r&&t0(i,n,s,r);let a=i;for(;i.prev!==i.next;){let l=i.prev,c=i.next;if(r?qg(i,n,s,r):Xg(i)){t.push(l.i,i.i,c.i),so(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=$g(cs(i),t),no(i,t,e,n,s,r,2)):o===2&&Yg(i,t,e,n,s,r):no(cs(i),t,e,n,s,r,1);break}}}function Xg(i){let t=i.prev,e=i,n=i.next;if(Ae(t,e,n)>=0)return!1;let s=t.x,r=e.x,o=n.x,a=t.y,l=e.y,c=n.y,h=Math.min(s,r,o),d=Math.min(a,l,c),u=Math.max(s,r,o),f=Math.max(a,l,c),m=n.next;for(;m!==t;){if(m.x>=h&&m.x<=u&&m.y>=d&&m.y<=f&&Ir(s,a,r,l,o,c,m.x,m.y)&&Ae(m.prev,m,m.next)>=0)return!1;m=m.next}return!0}function qg(i,t,e,n){let s=i.prev,r=i,o=i.next;if(Ae(s,r,o)>=0)return!1;let a=s.x,l=r.x,c=o.x,h=s.y,d=r.y,u=o.y,f=Math.min(a,l,c),m=Math.min(h,d,u),v=Math.max(a,l,c),p=Math.max(h,d,u),g=oh(f,m,t,e,n),x=oh(v,p,t,e,n),b=i.prevZ,M=i.nextZ;for(;b&&b.z>=g&&M&&M.z<=x;){if(b.x>=f&&b.x<=v&&b.y>=m&&b.y<=p&&b!==s&&b!==o&&Ir(a,h,l,d,c,u,b.x,b.y)&&Ae(b.prev,b,b.next)>=0||(b=b.prevZ,M.x>=f&&M.x<=v&&M.y>=m&&M.y<=p&&M!==s&&M!==o&&Ir(a,h,l,d,c,u,M.x,M.y)&&Ae(M.prev,M,M.next)>=0))return!1;M=M.nextZ}for(;b&&b.z>=g;){if(b.x>=f&&b.x<=v&&b.y>=m&&b.y<=p&&b!==s&&b!==o&&Ir(a,h,l,d,c,u,b.x,b.y)&&Ae(b.prev,b,b.next)>=0)return!1;b=b.prevZ}for(;M&&M.z<=x;){if(M.x>=f&&M.x<=v&&M.y>=m&&M.y<=p&&M!==s&&M!==o&&Ir(a,h,l,d,c,u,M.x,M.y)&&Ae(M.prev,M,M.next)>=0)return!1;M=M.nextZ}return!0}function $g(i,t){let e=i;do{let n=e.prev,s=e.next.next;!Qs(n,s)&&Bf(n,e,e.next,s)&&io(n,s)&&io(s,n)&&(t.push(n.i,e.i,s.i),so(e),so(e.next),e=i=s),e=e.next}while(e!==i);return cs(e)}function Yg(i,t,e,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&i0(o,a)){let l=kf(o,a);o=cs(o,o.next),l=cs(l,l.next),no(o,t,e,n,s,r,0),no(l,t,e,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function Zg(i,t,e,n){let s=[];for(let r=0,o=t.length;r<o;r++){let a=t[r]*n,l=r<o-1?t[r+1]*n:i.length,c=Of(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(n0(c))}s.sort(Jg);for(let r=0;r<s.length;r++)e=Kg(s[r],e);return e}function Jg(i,t){let e=i.x-t.x;if(e===0&&(e=i.y-t.y,e===0)){let n=(i.next.y-i.y)/(i.next.x-i.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=n-s}return e}function Kg(i,t){let e=jg(i,t);if(!e)return t;let n=kf(e,i);return cs(n,n.next),cs(e,e.next)}function jg(i,t){let e=t,n=i.x,s=i.y,r=-1/0,o;if(Qs(i,e))return e;do{if(Qs(i,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){let d=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(d<=n&&d>r&&(r=d,o=e.x<e.next.x?e:e.next,d===n))return o}e=e.next}while(e!==t);if(!o)return null;let a=o,l=o.x,c=o.y,h=1/0;e=o;do{if(n>=e.x&&e.x>=l&&n!==e.x&&Ff(s<c?n:r,s,l,c,s<c?r:n,s,e.x,e.y)){let d=Math.abs(s-e.y)/(n-e.x);io(e,i)&&(d<h||d===h&&(e.x>o.x||e.x===o.x&&Qg(o,e)))&&(o=e,h=d)}e=e.next}while(e!==a);return o}function Qg(i,t){return Ae(i.prev,i,t.prev)<0&&Ae(t.next,i,i.next)<0}function t0(i,t,e,n){let s=i;do s.z===0&&(s.z=oh(s.x,s.y,t,e,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,e0(s)}function e0(i){let t,e=1;do{let n=i,s;i=null;let r=null;for(t=0;n;){t++;let o=n,a=0;for(let c=0;c<e&&(a++,o=o.nextZ,!!o);c++);let l=e;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,e*=2}while(t>1);return i}function oh(i,t,e,n,s){return i=(i-e)*s|0,t=(t-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,i|t<<1}function n0(i){let t=i,e=i;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==i);return e}function Ff(i,t,e,n,s,r,o,a){return(s-o)*(t-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(s-o)*(n-a)}function Ir(i,t,e,n,s,r,o,a){return!(i===o&&t===a)&&Ff(i,t,e,n,s,r,o,a)}function i0(i,t){return i.next.i!==t.i&&i.prev.i!==t.i&&!s0(i,t)&&(io(i,t)&&io(t,i)&&r0(i,t)&&(Ae(i.prev,i,t.prev)||Ae(i,t.prev,t))||Qs(i,t)&&Ae(i.prev,i,i.next)>0&&Ae(t.prev,t,t.next)>0)}function Ae(i,t,e){return(t.y-i.y)*(e.x-t.x)-(t.x-i.x)*(e.y-t.y)}function Qs(i,t){return i.x===t.x&&i.y===t.y}function Bf(i,t,e,n){let s=pa(Ae(i,t,e)),r=pa(Ae(i,t,n)),o=pa(Ae(e,n,i)),a=pa(Ae(e,n,t));return!!(s!==r&&o!==a||s===0&&fa(i,e,t)||r===0&&fa(i,n,t)||o===0&&fa(e,i,n)||a===0&&fa(e,t,n))}function fa(i,t,e){return t.x<=Math.max(i.x,e.x)&&t.x>=Math.min(i.x,e.x)&&t.y<=Math.max(i.y,e.y)&&t.y>=Math.min(i.y,e.y)}function pa(i){return i>0?1:i<0?-1:0}function s0(i,t){let e=i;do{if(e.i!==i.i&&e.next.i!==i.i&&e.i!==t.i&&e.next.i!==t.i&&Bf(e,e.next,i,t))return!0;e=e.next}while(e!==i);return!1}function io(i,t){return Ae(i.prev,i,i.next)<0?Ae(i,t,i.next)>=0&&Ae(i,i.prev,t)>=0:Ae(i,t,i.prev)<0||Ae(i,i.next,t)<0}function r0(i,t){let e=i,n=!1,s=(i.x+t.x)/2,r=(i.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(n=!n),e=e.next;while(e!==i);return n}function kf(i,t){let e=ah(i.i,i.x,i.y),n=ah(t.i,t.x,t.y),s=i.next,r=t.prev;return i.next=t,t.prev=i,e.next=s,s.prev=e,n.next=e,e.prev=n,r.next=n,n.prev=r,n}function kd(i,t,e,n){let s=ah(i,t,e);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function so(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function ah(i,t,e){return{i,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function o0(i,t,e,n){let s=0;for(let r=t,o=e-n;r<e;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}var lh=class{static triangulate(t,e,n=2){return Wg(t,e,n)}},Gs=class i{static area(t){let e=t.length,n=0;for(let s=e-1,r=0;r<e;s=r++)n+=t[s].x*t[r].y-t[r].x*t[s].y;return n*.5}static isClockWise(t){return i.area(t)<0}static triangulateShape(t,e){let n=[],s=[],r=[];zd(t),Gd(n,t);let o=t.length;e.forEach(zd);for(let l=0;l<e.length;l++)s.push(o),o+=e[l].length,Gd(n,e[l]);let a=lh.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}};function zd(i){let t=i.length;t>2&&i[t-1].equals(i[0])&&i.pop()}function Gd(i,t){for(let e=0;e<t.length;e++)i.push(t[e].x),i.push(t[e].y)}var Oi=class i extends $e{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,d=t/a,u=e/l,f=[],m=[],v=[],p=[];for(let g=0;g<h;g++){let x=g*u-o;for(let b=0;b<c;b++){let M=b*d-r;m.push(M,-x,0),v.push(0,0,1),p.push(b/a),p.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let b=x+c*g,M=x+c*(g+1),E=x+1+c*(g+1),S=x+1+c*g;f.push(b,M,S),f.push(M,E,S)}this.setIndex(f),this.setAttribute("position",new Te(m,3)),this.setAttribute("normal",new Te(v,3)),this.setAttribute("uv",new Te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var ro=class i extends $e{constructor(t=new js([new bt(0,.5),new bt(-.5,-.5),new bt(.5,-.5)]),e=12){super(),this.type="ShapeGeometry",this.parameters={shapes:t,curveSegments:e};let n=[],s=[],r=[],o=[],a=0,l=0;if(Array.isArray(t)===!1)c(t);else for(let h=0;h<t.length;h++)c(t[h]),this.addGroup(a,l,h),a+=l,l=0;this.setIndex(n),this.setAttribute("position",new Te(s,3)),this.setAttribute("normal",new Te(r,3)),this.setAttribute("uv",new Te(o,2));function c(h){let d=s.length/3,u=h.extractPoints(e),f=u.shape,m=u.holes;Gs.isClockWise(f)===!1&&(f=f.reverse());for(let p=0,g=m.length;p<g;p++){let x=m[p];Gs.isClockWise(x)===!0&&(m[p]=x.reverse())}let v=Gs.triangulateShape(f,m);for(let p=0,g=m.length;p<g;p++){let x=m[p];f=f.concat(x)}for(let p=0,g=f.length;p<g;p++){let x=f[p];s.push(x.x,x.y,0),r.push(0,0,1),o.push(x.x,x.y)}for(let p=0,g=v.length;p<g;p++){let x=v[p],b=x[0]+d,M=x[1]+d,E=x[2]+d;n.push(b,M,E),l+=3}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON(),e=this.parameters.shapes;return a0(e,t)}static fromJSON(t,e){let n=[];for(let s=0,r=t.shapes.length;s<r;s++){let o=e[t.shapes[s]];n.push(o)}return new i(n,t.curveSegments)}};function a0(i,t){if(t.shapes=[],Array.isArray(i))for(let e=0,n=i.length;e<n;e++){let s=i[e];t.shapes.push(s.uuid)}else t.shapes.push(i.uuid);return t}var oo=class i extends $e{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],d=new q,u=new q,f=[],m=[],v=[],p=[];for(let g=0;g<=n;g++){let x=[],b=g/n,M=o+b*a,E=t*Math.cos(M),S=Math.sqrt(t*t-E*E),_=0;g===0&&o===0?_=.5/e:g===n&&l===Math.PI&&(_=-.5/e);for(let y=0;y<=e;y++){let R=y/e,A=s+R*r;d.x=-S*Math.cos(A),d.y=E,d.z=S*Math.sin(A),m.push(d.x,d.y,d.z),u.copy(d).normalize(),v.push(u.x,u.y,u.z),p.push(R+_,1-b),x.push(c++)}h.push(x)}for(let g=0;g<n;g++)for(let x=0;x<e;x++){let b=h[g][x+1],M=h[g][x],E=h[g+1][x],S=h[g+1][x+1];(g!==0||o>0)&&f.push(b,M,S),(g!==n-1||l<Math.PI)&&f.push(M,E,S)}this.setIndex(f),this.setAttribute("position",new Te(m,3)),this.setAttribute("normal",new Te(v,3)),this.setAttribute("uv",new Te(p,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var ao=class extends mi{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Yt(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function gs(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(Hd(s))s.isRenderTargetTexture?(Gt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Hd(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function nn(i){let t={};for(let e=0;e<i.length;e++){let n=gs(i[e]);for(let s in n)t[s]=n[s]}return t}function Hd(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function l0(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Vh(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:re.workingColorSpace}var zf={clone:gs,merge:nn},c0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,h0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,In=class extends mi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=c0,this.fragmentShader=h0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=gs(t.uniforms),this.uniformsGroups=l0(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new Yt().setHex(s.value);break;case"v2":this.uniforms[n].value=new bt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new q().fromArray(s.value);break;case"v4":this.uniforms[n].value=new be().fromArray(s.value);break;case"m3":this.uniforms[n].value=new qt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new ge().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},ka=class extends In{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},lo=class extends mi{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Yt(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Yt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=zl,this.normalScale=new bt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new pi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var za=class extends mi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=vf,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Ga=class extends mi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Fs(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function ma(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Fi=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ha=class extends Fi{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ih,endingEnd:ih}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case sh:r=t,a=2*e-n;break;case rh:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case sh:o=t,l=2*n-e;break;case rh:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,m=(n-e)/(s-e),v=m*m,p=v*m,g=-u*p+2*u*v-u*m,x=(1+u)*p+(-1.5-2*u)*v+(-.5+u)*m+1,b=(-1-f)*p+(1.5+f)*v+.5*m,M=f*p-f*v;for(let E=0;E!==a;++E)r[E]=g*o[h+E]+x*o[c+E]+b*o[l+E]+M*o[d+E];return r}},Va=class extends Fi{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},Wa=class extends Fi{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Xa=class extends Fi{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let m=(n-e)/(s-e),v=1-m;for(let p=0;p!==a;++p)r[p]=o[c+p]*v+o[l+p]*m;return r}let u=a*2,f=t-1;for(let m=0;m!==a;++m){let v=o[c+m],p=o[l+m],g=f*u+m*2,x=d[g],b=d[g+1],M=t*u+m*2,E=h[M],S=h[M+1],_=d0(n,e,x,E,s);r[m]=Gf(_,v,b,S,p)}return r}};function Gf(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function u0(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function d0(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=Gf(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=u0(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var En=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Fs(e,this.TimeBufferType),this.values=Fs(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Fs(t.times,Array),values:Fs(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),ma(t.settings)&&(n.settings={inTangents:Fs(t.settings.inTangents,Array),outTangents:Fs(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Wa(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Va(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ha(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Xa(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Fr:e=this.InterpolantFactoryMethodDiscrete;break;case Ra:e=this.InterpolantFactoryMethodLinear;break;case xa:e=this.InterpolantFactoryMethodSmooth;break;case nh:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Gt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Fr;case this.InterpolantFactoryMethodLinear:return Ra;case this.InterpolantFactoryMethodSmooth:return xa;case this.InterpolantFactoryMethodBezier:return nh}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;ma(this.settings)&&(Vd(this.settings.inTangents,t),Vd(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;ma(this.settings)&&(Wd(this.settings.inTangents,t),Wd(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Wt("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Wt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Wt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Wt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&ng(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Wt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===xa,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*n,u=d-n,f=d+n;for(let m=0;m!==n;++m){let v=e[d+m];if(v!==e[u+m]||v!==e[f+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*n,u=o*n;for(let f=0;f!==n;++f)e[u+f]=e[d+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,ma(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Vd(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function Wd(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}En.prototype.ValueTypeName="";En.prototype.TimeBufferType=Float32Array;En.prototype.ValueBufferType=Float32Array;En.prototype.DefaultInterpolation=Ra;var Bi=class extends En{constructor(t,e,n){super(t,e,n)}};Bi.prototype.ValueTypeName="bool";Bi.prototype.ValueBufferType=Array;Bi.prototype.DefaultInterpolation=Fr;Bi.prototype.InterpolantFactoryMethodLinear=void 0;Bi.prototype.InterpolantFactoryMethodSmooth=void 0;var qa=class extends En{constructor(t,e,n,s){super(t,e,n,s)}};qa.prototype.ValueTypeName="color";var $a=class extends En{constructor(t,e,n,s){super(t,e,n,s)}};$a.prototype.ValueTypeName="number";var Ya=class extends Fi{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Sn.slerpFlat(r,0,o,c-a,o,c,l);return r}},co=class extends En{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Ya(this.times,this.values,this.getValueSize(),t)}};co.prototype.ValueTypeName="quaternion";co.prototype.InterpolantFactoryMethodSmooth=void 0;var ki=class extends En{constructor(t,e,n){super(t,e,n)}};ki.prototype.ValueTypeName="string";ki.prototype.ValueBufferType=Array;ki.prototype.DefaultInterpolation=Fr;ki.prototype.InterpolantFactoryMethodLinear=void 0;ki.prototype.InterpolantFactoryMethodSmooth=void 0;var Za=class extends En{constructor(t,e,n,s){super(t,e,n,s)}};Za.prototype.ValueTypeName="vector";var Ja=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],m=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Hf=new Ja,Ka=class{constructor(t){this.manager=t!==void 0?t:Hf,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Ka.DEFAULT_MATERIAL_NAME="__DEFAULT";var ho=class extends en{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Yt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},uo=class extends ho{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(en.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Yt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},eh=new ge,Xd=new q,qd=new q,ja=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new bt(512,512),this.mapType=pn,this.map=null,this.mapPass=null,this.matrix=new ge,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ui,this._frameExtents=new bt(1,1),this._viewportCount=1,this._viewports=[new be(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Xd.setFromMatrixPosition(t.matrixWorld),e.position.copy(Xd),qd.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(qd),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){eh.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(eh,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Ws||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(eh)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},ga=new q,_a=new Sn,$n=new q,fo=class extends en{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ge,this.projectionMatrix=new ge,this.projectionMatrixInverse=new ge,this.coordinateSystem=Pn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(ga,_a,$n),$n.x===1&&$n.y===1&&$n.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ga,_a,$n.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(ga,_a,$n),$n.x===1&&$n.y===1&&$n.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ga,_a,$n.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Li=new q,$d=new bt,Yd=new bt,an=class extends fo{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=qs*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Dr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return qs*2*Math.atan(Math.tan(Dr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Li.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Li.x,Li.y).multiplyScalar(-t/Li.z),Li.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Li.x,Li.y).multiplyScalar(-t/Li.z)}getViewSize(t,e){return this.getViewBounds(t,$d,Yd),e.subVectors(Yd,$d)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Dr*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var po=class extends fo{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},ch=class extends ja{constructor(){super(new po(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},mo=class extends ho{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(en.DEFAULT_UP),this.updateMatrix(),this.target=new en,this.shadow=new ch}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var go=class extends $e{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var Bs=-90,ks=1,tr=class extends en{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new an(Bs,ks,t,e);s.layers=this.layers,this.add(s);let r=new an(Bs,ks,t,e);r.layers=this.layers,this.add(r);let o=new an(Bs,ks,t,e);o.layers=this.layers,this.add(o);let a=new an(Bs,ks,t,e);a.layers=this.layers,this.add(a);let l=new an(Bs,ks,t,e);l.layers=this.layers,this.add(l);let c=new an(Bs,ks,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Pn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Ws)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;t.isWebGLRenderer===!0?p=t.state.buffers.depth.getReversed():p=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=v,t.setRenderTarget(n,5,s),p&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(d,u,f),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Qa=class extends an{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Wh="\\[\\]\\.:\\/",f0=new RegExp("["+Wh+"]","g"),Xh="[^"+Wh+"]",p0="[^"+Wh.replace("\\.","")+"]",m0=/((?:WC+[\/:])*)/.source.replace("WC",Xh),g0=/(WCOD+)?/.source.replace("WCOD",p0),_0=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Xh),x0=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Xh),y0=new RegExp("^"+m0+g0+_0+x0+"$"),v0=["material","materials","bones","map"],hh=class{constructor(t,e,n){let s=n||Me.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},Me=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(f0,"")}static parseTrackName(t){let e=y0.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);v0.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Gt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){Wt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Wt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Wt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Wt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Wt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){Wt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){Wt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Wt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Wt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Wt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Me.Composite=hh;Me.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Me.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Me.prototype.GetterByBindingType=[Me.prototype._getValue_direct,Me.prototype._getValue_array,Me.prototype._getValue_arrayElement,Me.prototype._getValue_toArray];Me.prototype.SetterByBindingTypeAndVersioning=[[Me.prototype._setValue_direct,Me.prototype._setValue_direct_setNeedsUpdate,Me.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Me.prototype._setValue_array,Me.prototype._setValue_array_setNeedsUpdate,Me.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Me.prototype._setValue_arrayElement,Me.prototype._setValue_arrayElement_setNeedsUpdate,Me.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Me.prototype._setValue_fromArray,Me.prototype._setValue_fromArray_setNeedsUpdate,Me.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Sb=new Float32Array(1);var er=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ee(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ee(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var uh=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var _o=class extends zn{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function qh(i,t,e,n){let s=M0(n);switch(e){case Ih:return i*t;case ol:return i*t/s.components*s.byteLength;case al:return i*t/s.components*s.byteLength;case Hi:return i*t*2/s.components*s.byteLength;case ll:return i*t*2/s.components*s.byteLength;case Lh:return i*t*3/s.components*s.byteLength;case An:return i*t*4/s.components*s.byteLength;case cl:return i*t*4/s.components*s.byteLength;case yo:case vo:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Mo:case So:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ul:case fl:return Math.max(i,16)*Math.max(t,8)/4;case hl:case dl:return Math.max(i,8)*Math.max(t,8)/2;case pl:case ml:case _l:case xl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case gl:case bo:case yl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case vl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Ml:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Sl:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case bl:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case wl:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case El:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Al:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Tl:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Rl:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Cl:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Pl:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Il:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Ll:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Dl:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Nl:case Ul:case Ol:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Fl:case Bl:return Math.ceil(i/4)*Math.ceil(t/4)*8;case wo:case kl:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function M0(i){switch(i){case pn:case Th:return{byteLength:1,components:1};case rr:case Rh:case Hn:return{byteLength:2,components:1};case sl:case rl:return{byteLength:2,components:4};case Gn:case il:case mn:return{byteLength:4,components:1};case Ch:case Ph:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Gt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function hp(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function b0(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,l,c){let h=l.array,d=l.updateRanges;if(i.bindBuffer(c,a),d.length===0)i.bufferSubData(c,0,h);else{d.sort((f,m)=>f.start-m.start);let u=0;for(let f=1;f<d.length;f++){let m=d[u],v=d[f];v.start<=m.start+m.count+1?m.count=Math.max(m.count,v.start+v.count-m.start):(++u,d[u]=v)}d.length=u+1;for(let f=0,m=d.length;f<m;f++){let v=d[f];i.bufferSubData(c,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var w0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,E0=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,A0=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,T0=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,R0=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,C0=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,P0=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,I0=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,L0=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,D0=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,N0=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,U0=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,O0=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,F0=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,B0=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,k0=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,z0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,G0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,H0=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,V0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,W0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,X0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,q0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,$0=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,Y0=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Z0=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,J0=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,K0=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,j0=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Q0="gl_FragColor = linearToOutputTexel( gl_FragColor );",t_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,e_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,n_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,i_=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,s_=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,r_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,o_=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,a_=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,l_=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,c_=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,h_=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,u_=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,d_=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,f_=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,p_=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,m_=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,g_=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,__=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,x_=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,y_=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,v_=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,M_=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,S_=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,b_=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,w_=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,E_=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,A_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,T_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,R_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,C_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,P_=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,I_=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,L_=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,D_=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,N_=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,U_=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,O_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,F_=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,B_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,k_=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,z_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,G_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,H_=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,V_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,W_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,X_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,q_=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,$_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Y_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Z_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,J_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,K_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,j_=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Q_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,tx=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,ex=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,nx=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,ix=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,sx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,rx=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,ox=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,ax=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,lx=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,cx=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,hx=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,ux=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,dx=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,fx=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,px=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,mx=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,gx=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,_x=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,xx=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,yx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,vx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Mx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Sx=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,bx=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,wx=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ex=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ax=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Tx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Rx=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Cx=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Px=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Ix=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Lx=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Dx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Nx=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ux=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Ox=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Fx=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Bx=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kx=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,zx=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Gx=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Hx=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Vx=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Wx=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Xx=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,qx=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$x=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Yx=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Zx=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Jx=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Kx=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,jx=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Qx=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,ty=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ey=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,ny=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ne={alphahash_fragment:w0,alphahash_pars_fragment:E0,alphamap_fragment:A0,alphamap_pars_fragment:T0,alphatest_fragment:R0,alphatest_pars_fragment:C0,aomap_fragment:P0,aomap_pars_fragment:I0,batching_pars_vertex:L0,batching_vertex:D0,begin_vertex:N0,beginnormal_vertex:U0,bsdfs:O0,iridescence_fragment:F0,bumpmap_pars_fragment:B0,clipping_planes_fragment:k0,clipping_planes_pars_fragment:z0,clipping_planes_pars_vertex:G0,clipping_planes_vertex:H0,color_fragment:V0,color_pars_fragment:W0,color_pars_vertex:X0,color_vertex:q0,common:$0,defaultnormal_vertex:Y0,displacementmap_pars_vertex:Z0,displacementmap_vertex:J0,emissivemap_fragment:K0,emissivemap_pars_fragment:j0,colorspace_fragment:Q0,colorspace_pars_fragment:t_,envmap_fragment:e_,envmap_common_pars_fragment:n_,envmap_pars_fragment:i_,envmap_pars_vertex:s_,envmap_physical_pars_fragment:m_,envmap_vertex:r_,fog_vertex:o_,fog_pars_vertex:a_,fog_fragment:l_,fog_pars_fragment:c_,gradientmap_pars_fragment:h_,lightmap_pars_fragment:u_,lights_lambert_fragment:d_,lights_lambert_pars_fragment:f_,lights_pars_begin:p_,lights_toon_fragment:g_,lights_toon_pars_fragment:__,lights_phong_fragment:x_,lights_phong_pars_fragment:y_,lights_physical_fragment:v_,lights_physical_pars_fragment:M_,lights_fragment_begin:S_,lights_fragment_maps:b_,lights_fragment_end:w_,lightprobes_pars_fragment:E_,logdepthbuf_fragment:A_,logdepthbuf_pars_fragment:T_,logdepthbuf_pars_vertex:R_,logdepthbuf_vertex:C_,map_fragment:P_,map_pars_fragment:I_,map_particle_fragment:L_,map_particle_pars_fragment:D_,metalnessmap_fragment:N_,metalnessmap_pars_fragment:U_,morphinstance_vertex:O_,morphcolor_vertex:F_,morphnormal_vertex:B_,morphtarget_pars_vertex:k_,morphtarget_vertex:z_,normal_fragment_begin:G_,normal_fragment_maps:H_,normal_pars_fragment:V_,normal_pars_vertex:W_,normal_vertex:X_,normalmap_pars_fragment:q_,clearcoat_normal_fragment_begin:$_,clearcoat_normal_fragment_maps:Y_,clearcoat_pars_fragment:Z_,iridescence_pars_fragment:J_,opaque_fragment:K_,packing:j_,premultiplied_alpha_fragment:Q_,project_vertex:tx,dithering_fragment:ex,dithering_pars_fragment:nx,roughnessmap_fragment:ix,roughnessmap_pars_fragment:sx,shadowmap_pars_fragment:rx,shadowmap_pars_vertex:ox,shadowmap_vertex:ax,shadowmask_pars_fragment:lx,skinbase_vertex:cx,skinning_pars_vertex:hx,skinning_vertex:ux,skinnormal_vertex:dx,specularmap_fragment:fx,specularmap_pars_fragment:px,tonemapping_fragment:mx,tonemapping_pars_fragment:gx,transmission_fragment:_x,transmission_pars_fragment:xx,uv_pars_fragment:yx,uv_pars_vertex:vx,uv_vertex:Mx,worldpos_vertex:Sx,background_vert:bx,background_frag:wx,backgroundCube_vert:Ex,backgroundCube_frag:Ax,cube_vert:Tx,cube_frag:Rx,depth_vert:Cx,depth_frag:Px,distance_vert:Ix,distance_frag:Lx,equirect_vert:Dx,equirect_frag:Nx,linedashed_vert:Ux,linedashed_frag:Ox,meshbasic_vert:Fx,meshbasic_frag:Bx,meshlambert_vert:kx,meshlambert_frag:zx,meshmatcap_vert:Gx,meshmatcap_frag:Hx,meshnormal_vert:Vx,meshnormal_frag:Wx,meshphong_vert:Xx,meshphong_frag:qx,meshphysical_vert:$x,meshphysical_frag:Yx,meshtoon_vert:Zx,meshtoon_frag:Jx,points_vert:Kx,points_frag:jx,shadow_vert:Qx,shadow_frag:ty,sprite_vert:ey,sprite_frag:ny},Et={common:{diffuse:{value:new Yt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new qt},alphaMap:{value:null},alphaMapTransform:{value:new qt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new qt}},envmap:{envMap:{value:null},envMapRotation:{value:new qt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new qt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new qt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new qt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new qt},normalScale:{value:new bt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new qt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new qt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new qt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new qt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Yt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Yt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new qt},alphaTest:{value:0},uvTransform:{value:new qt}},sprite:{diffuse:{value:new Yt(16777215)},opacity:{value:1},center:{value:new bt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new qt},alphaMap:{value:null},alphaMapTransform:{value:new qt},alphaTest:{value:0}}},Qn={basic:{uniforms:nn([Et.common,Et.specularmap,Et.envmap,Et.aomap,Et.lightmap,Et.fog]),vertexShader:ne.meshbasic_vert,fragmentShader:ne.meshbasic_frag},lambert:{uniforms:nn([Et.common,Et.specularmap,Et.envmap,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.fog,Et.lights,{emissive:{value:new Yt(0)},envMapIntensity:{value:1}}]),vertexShader:ne.meshlambert_vert,fragmentShader:ne.meshlambert_frag},phong:{uniforms:nn([Et.common,Et.specularmap,Et.envmap,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.fog,Et.lights,{emissive:{value:new Yt(0)},specular:{value:new Yt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ne.meshphong_vert,fragmentShader:ne.meshphong_frag},standard:{uniforms:nn([Et.common,Et.envmap,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.roughnessmap,Et.metalnessmap,Et.fog,Et.lights,{emissive:{value:new Yt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ne.meshphysical_vert,fragmentShader:ne.meshphysical_frag},toon:{uniforms:nn([Et.common,Et.aomap,Et.lightmap,Et.emissivemap,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.gradientmap,Et.fog,Et.lights,{emissive:{value:new Yt(0)}}]),vertexShader:ne.meshtoon_vert,fragmentShader:ne.meshtoon_frag},matcap:{uniforms:nn([Et.common,Et.bumpmap,Et.normalmap,Et.displacementmap,Et.fog,{matcap:{value:null}}]),vertexShader:ne.meshmatcap_vert,fragmentShader:ne.meshmatcap_frag},points:{uniforms:nn([Et.points,Et.fog]),vertexShader:ne.points_vert,fragmentShader:ne.points_frag},dashed:{uniforms:nn([Et.common,Et.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ne.linedashed_vert,fragmentShader:ne.linedashed_frag},depth:{uniforms:nn([Et.common,Et.displacementmap]),vertexShader:ne.depth_vert,fragmentShader:ne.depth_frag},normal:{uniforms:nn([Et.common,Et.bumpmap,Et.normalmap,Et.displacementmap,{opacity:{value:1}}]),vertexShader:ne.meshnormal_vert,fragmentShader:ne.meshnormal_frag},sprite:{uniforms:nn([Et.sprite,Et.fog]),vertexShader:ne.sprite_vert,fragmentShader:ne.sprite_frag},background:{uniforms:{uvTransform:{value:new qt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ne.background_vert,fragmentShader:ne.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new qt}},vertexShader:ne.backgroundCube_vert,fragmentShader:ne.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ne.cube_vert,fragmentShader:ne.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ne.equirect_vert,fragmentShader:ne.equirect_frag},distance:{uniforms:nn([Et.common,Et.displacementmap,{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ne.distance_vert,fragmentShader:ne.distance_frag},shadow:{uniforms:nn([Et.lights,Et.fog,{color:{value:new Yt(0)},opacity:{value:1}}]),vertexShader:ne.shadow_vert,fragmentShader:ne.shadow_frag}};Qn.physical={uniforms:nn([Qn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new qt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new qt},clearcoatNormalScale:{value:new bt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new qt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new qt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new qt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new qt},sheen:{value:0},sheenColor:{value:new Yt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new qt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new qt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new qt},transmissionSamplerSize:{value:new bt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new qt},attenuationDistance:{value:0},attenuationColor:{value:new Yt(0)},specularColor:{value:new Yt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new qt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new qt},anisotropyVector:{value:new bt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new qt}}]),vertexShader:ne.meshphysical_vert,fragmentShader:ne.meshphysical_frag};var Gl={r:0,b:0,g:0},iy=new ge,up=new qt;up.set(-1,0,0,0,1,0,0,0,1);function sy(i,t,e,n,s,r){let o=new Yt(0),a=s===!0?0:1,l,c,h=null,d=0,u=null;function f(x){let b=x.isScene===!0?x.background:null;if(b&&b.isTexture){let M=x.backgroundBlurriness>0;b=t.get(b,M)}return b}function m(x){let b=!1,M=f(x);M===null?p(o,a):M&&M.isColor&&(p(M,1),b=!0);let E=i.xr.getEnvironmentBlendMode();E==="additive"?e.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||b)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(x,b){let M=f(b);M&&M.isCubeTexture?(c===void 0&&(c=new we(new Js(1,1,1),new In({name:"BackgroundCubeMaterial",uniforms:gs(Qn.backgroundCube.uniforms),vertexShader:Qn.backgroundCube.vertexShader,fragmentShader:Qn.backgroundCube.fragmentShader,side:un,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,S,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(iy.makeRotationFromEuler(b.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(up),c.material.toneMapped=re.getTransfer(M.colorSpace)!==me,(h!==M||d!==M.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,d=M.version,u=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new we(new Oi(2,2),new In({name:"BackgroundMaterial",uniforms:gs(Qn.background.uniforms),vertexShader:Qn.background.vertexShader,fragmentShader:Qn.background.fragmentShader,side:Jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.toneMapped=re.getTransfer(M.colorSpace)!==me,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||d!==M.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=M,d=M.version,u=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function p(x,b){x.getRGB(Gl,Vh(i)),e.buffers.color.setClear(Gl.r,Gl.g,Gl.b,b,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,b=1){o.set(x),a=b,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:m,addToRenderList:v,dispose:g}}function ry(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null),r=s,o=!1;function a(C,N,O,I,k){let D=!1,L=d(C,I,O,N);r!==L&&(r=L,c(r.object)),D=f(C,I,O,k),D&&m(C,I,O,k),k!==null&&t.update(k,i.ELEMENT_ARRAY_BUFFER),(D||o)&&(o=!1,M(C,N,O,I),k!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(k).buffer))}function l(){return i.createVertexArray()}function c(C){return i.bindVertexArray(C)}function h(C){return i.deleteVertexArray(C)}function d(C,N,O,I){let k=I.wireframe===!0,D=n[N.id];D===void 0&&(D={},n[N.id]=D);let L=C.isInstancedMesh===!0?C.id:0,B=D[L];B===void 0&&(B={},D[L]=B);let z=B[O.id];z===void 0&&(z={},B[O.id]=z);let F=z[k];return F===void 0&&(F=u(l()),z[k]=F),F}function u(C){let N=[],O=[],I=[];for(let k=0;k<e;k++)N[k]=0,O[k]=0,I[k]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:N,enabledAttributes:O,attributeDivisors:I,object:C,attributes:{},index:null}}function f(C,N,O,I){let k=r.attributes,D=N.attributes,L=0,B=O.getAttributes();for(let z in B)if(B[z].location>=0){let X=k[z],et=D[z];if(et===void 0&&(z==="instanceMatrix"&&C.instanceMatrix&&(et=C.instanceMatrix),z==="instanceColor"&&C.instanceColor&&(et=C.instanceColor)),X===void 0||X.attribute!==et||et&&X.data!==et.data)return!0;L++}return r.attributesNum!==L||r.index!==I}function m(C,N,O,I){let k={},D=N.attributes,L=0,B=O.getAttributes();for(let z in B)if(B[z].location>=0){let X=D[z];X===void 0&&(z==="instanceMatrix"&&C.instanceMatrix&&(X=C.instanceMatrix),z==="instanceColor"&&C.instanceColor&&(X=C.instanceColor));let et={};et.attribute=X,X&&X.data&&(et.data=X.data),k[z]=et,L++}r.attributes=k,r.attributesNum=L,r.index=I}function v(){let C=r.newAttributes;for(let N=0,O=C.length;N<O;N++)C[N]=0}function p(C){g(C,0)}function g(C,N){let O=r.newAttributes,I=r.enabledAttributes,k=r.attributeDivisors;O[C]=1,I[C]===0&&(i.enableVertexAttribArray(C),I[C]=1),k[C]!==N&&(i.vertexAttribDivisor(C,N),k[C]=N)}function x(){let C=r.newAttributes,N=r.enabledAttributes;for(let O=0,I=N.length;O<I;O++)N[O]!==C[O]&&(i.disableVertexAttribArray(O),N[O]=0)}function b(C,N,O,I,k,D,L){L===!0?i.vertexAttribIPointer(C,N,O,k,D):i.vertexAttribPointer(C,N,O,I,k,D)}function M(C,N,O,I){v();let k=I.attributes,D=O.getAttributes(),L=N.defaultAttributeValues;for(let B in D){let z=D[B];if(z.location>=0){let F=k[B];if(F===void 0&&(B==="instanceMatrix"&&C.instanceMatrix&&(F=C.instanceMatrix),B==="instanceColor"&&C.instanceColor&&(F=C.instanceColor)),F!==void 0){let X=F.normalized,et=F.itemSize,W=t.get(F);if(W===void 0)continue;let U=W.buffer,Q=W.type,K=W.bytesPerElement,at=Q===i.INT||Q===i.UNSIGNED_INT||F.gpuType===il;if(F.isInterleavedBufferAttribute){let ot=F.data,It=ot.isInterleavedBuffer===!0?ot.stride:ot.itemSize,Xt=F.offset;if(ot.isInstancedInterleavedBuffer||ot.isInstancedBufferAttribute){for(let Ct=0;Ct<z.locationSize;Ct++)g(z.location+Ct,ot.meshPerAttribute);C.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let Ct=0;Ct<z.locationSize;Ct++)p(z.location+Ct);i.bindBuffer(i.ARRAY_BUFFER,U);for(let Ct=0;Ct<z.locationSize;Ct++)b(z.location+Ct,et/z.locationSize,Q,X,It*K,(Xt+et/z.locationSize*Ct)*K,at)}else{if(F.isInstancedBufferAttribute){for(let ot=0;ot<z.locationSize;ot++)g(z.location+ot,F.meshPerAttribute);C.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=F.meshPerAttribute*F.count)}else for(let ot=0;ot<z.locationSize;ot++)p(z.location+ot);i.bindBuffer(i.ARRAY_BUFFER,U);for(let ot=0;ot<z.locationSize;ot++)b(z.location+ot,et/z.locationSize,Q,X,et*K,et/z.locationSize*ot*K,at)}}else if(L!==void 0){let X=L[B];if(X!==void 0)switch(X.length){case 2:i.vertexAttrib2fv(z.location,X);break;case 3:i.vertexAttrib3fv(z.location,X);break;case 4:i.vertexAttrib4fv(z.location,X);break;default:i.vertexAttrib1fv(z.location,X)}}}}x()}function E(){R();for(let C in n){let N=n[C];for(let O in N){let I=N[O];for(let k in I){let D=I[k];for(let L in D)h(D[L].object),delete D[L];delete I[k]}}delete n[C]}}function S(C){if(n[C.id]===void 0)return;let N=n[C.id];for(let O in N){let I=N[O];for(let k in I){let D=I[k];for(let L in D)h(D[L].object),delete D[L];delete I[k]}}delete n[C.id]}function _(C){for(let N in n){let O=n[N];for(let I in O){let k=O[I];if(k[C.id]===void 0)continue;let D=k[C.id];for(let L in D)h(D[L].object),delete D[L];delete k[C.id]}}}function y(C){for(let N in n){let O=n[N],I=C.isInstancedMesh===!0?C.id:0,k=O[I];if(k!==void 0){for(let D in k){let L=k[D];for(let B in L)h(L[B].object),delete L[B];delete k[D]}delete O[I],Object.keys(O).length===0&&delete n[N]}}}function R(){A(),o=!0,r!==s&&(r=s,c(r.object))}function A(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:R,resetDefaultState:A,dispose:E,releaseStatesOfGeometry:S,releaseStatesOfObject:y,releaseStatesOfProgram:_,initAttributes:v,enableAttribute:p,disableUnusedAttributes:x}}function oy(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let f=0;f<h;f++)u+=c[f];e.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function ay(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==An&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let y=_===Hn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==pn&&_!==mn&&!y&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Gt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Gt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Gt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),b=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),E=i.getParameter(i.MAX_SAMPLES),S=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:m,maxTextureSize:v,maxCubemapSize:p,maxAttributes:g,maxVertexUniforms:x,maxVaryings:b,maxFragmentUniforms:M,maxSamples:E,samples:S}}function ly(i){let t=this,e=null,n=0,s=!1,r=!1,o=new Mn,a=new qt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||n!==0||s;return s=u,n=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,f){let m=d.clippingPlanes,v=d.clipIntersection,p=d.clipShadows,g=i.get(d);if(!s||m===null||m.length===0||r&&!p)r?h(null):c();else{let x=r?0:n,b=x*4,M=g.clippingState||null;l.value=M,M=h(m,u,b,f);for(let E=0;E!==b;++E)M[E]=e[E];g.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(d,u,f,m){let v=d!==null?d.length:0,p=null;if(v!==0){if(p=l.value,m!==!0||p===null){let g=f+v*4,x=u.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<g)&&(p=new Float32Array(g));for(let b=0,M=f;b!==v;++b,M+=4)o.copy(d[b]).applyMatrix4(x,a),o.normal.toArray(p,M),p[M+3]=o.constant}l.value=p,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,p}}var Ro=class extends bn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new $r(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Js(5,5,5),r=new In({name:"CubemapFromEquirect",uniforms:gs(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:un,blending:us});r.uniforms.tEquirect.value=e;let o=new we(s,r),a=e.minFilter;return e.minFilter===_i&&(e.minFilter=ln),new tr(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},Vf=256,cy=3,hy=20,dp=256,fp=16,uy=3,dy=new q,fy=new Yt,Vl=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new tr(1,10,null),this._boxMesh=new we(new Js(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=dy}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,v=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(t.background=l.getClearColor(fy));let p=new tr(n,s,h);return p.position.copy(a),p.update(l,t),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=m,t.background=v,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=qf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Xf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Vf,kh(t))}_fromTexture(t,e){t.mapping===fs||t.mapping===sr?this._setSize(t.image.length===0?Vf:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Wf(t,!1,!1),n=Math.log2(t)-cy;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Wf(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===fs||t.mapping===sr?(this._cubemapMaterial===null&&(this._cubemapMaterial=qf()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Xf()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=py(),this._integrationMaterial=my());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/fp);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-uy)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(dp*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=gy());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Wf(i,t,e){return new Ro(i,{minFilter:_i,generateMipmaps:t,type:Hn,colorSpace:os,depthBuffer:e})}function Co(i,t,e){return new In({name:i,uniforms:t,vertexShader:ne.cube_vert,fragmentShader:e,side:un,blending:us,depthTest:!1,depthWrite:!1})}function py(){return Co("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${dp}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function my(){return Co("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:fp}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function gy(){return Co("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${hy}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Xf(){return Co("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function qf(){return Co("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function _y(i){let t=new WeakMap,e=new WeakMap,n=null;function s(u,f=!1){return u==null?null:f?o(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===tl||f===el)if(t.has(u)){let m=t.get(u).texture;return a(m,u.mapping)}else{let m=u.image;if(m&&m.height>0){let v=new Ro(m.height);return v.fromEquirectangularTexture(i,u),t.set(u,v),u.addEventListener("dispose",c),a(v.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,m=f===tl||f===el,v=f===fs||f===sr;if(m||v){let p=e.get(u),g=p!==void 0?p.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==g)return n===null&&(n=new Vl(i)),p=m?n.fromEquirectangular(u,p):n.fromCubemap(u,p),p.texture.pmremVersion=u.pmremVersion,e.set(u,p),p.texture;if(p!==void 0)return p.texture;{let x=u.image;return m&&x&&x.height>0||v&&x&&l(x)?(n===null&&(n=new Vl(i)),p=m?n.fromEquirectangular(u):n.fromCubemap(u),p.texture.pmremVersion=u.pmremVersion,e.set(u,p),u.addEventListener("dispose",h),p.texture):null}}}return u}function a(u,f){return f===tl?u.mapping=fs:f===el&&(u.mapping=sr),u}function l(u){let f=0,m=6;for(let v=0;v<m;v++)u[v]!==void 0&&f++;return f===m}function c(u){let f=u.target;f.removeEventListener("dispose",c);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function d(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function xy(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Lr("WebGLRenderer: "+n+" extension not supported."),s}}}function yy(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let p in m.attributes)t.remove(m.attributes[p]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let v=r.get(m);v&&(t.remove(v),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),e.memory.geometries++),v}function h(m){let v=m.attributes;for(let p in v)t.update(v[p],i.ARRAY_BUFFER)}function d(m){let v=m.index,p=m.attributes.position,g=0;if(p===void 0)return;let x=v!==null?v.array.length:p.array.length/3-1,b=p.count>=65535?Xr:Wr,M=new b(Math.ceil(x/3)*6,1),E=M.array;if(v!==null){let _=v.array;g=v.version;for(let y=0,R=0;y<x;y+=3){let A=_[y+0],C=_[y+1],N=_[y+2];E[R++]=A,E[R++]=C,E[R++]=C,E[R++]=N,E[R++]=N,E[R++]=A}}else{g=p.version;for(let _=0,y=0;_<x;_+=3){let R=_+0,A=_+1,C=_+2;E[y++]=R,E[y++]=A,E[y++]=A,E[y++]=C,E[y++]=C,E[y++]=R}}M.version=g;let S=r.get(m);S&&t.remove(S),r.set(m,M)}function u(m){let v=r.get(m);if(v){let p=m.index;p!==null&&v.version<p.version&&d(m)}else d(m);return r.get(m)}function f(){for(let m in s){let v=s[m].deref();v!==void 0&&l(v)}}return{get:c,update:h,getWireframeAttribute:u,dispose:f}}function vy(i,t,e){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){i.drawElements(n,u,r,d*o),e.update(u,n,1)}function c(d,u,f){f!==0&&(i.drawElementsInstanced(n,u,r,d*o,f),e.update(u,n,f))}function h(d,u,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,f);let v=0;for(let p=0;p<f;p++)v+=u[p];e.update(v,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function My(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:Wt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function Sy(i,t,e){let n=new WeakMap,s=new be;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=n.get(a);if(u===void 0||u.count!==d){let R=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",R)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],b=0;f===!0&&(b=1),m===!0&&(b=2),v===!0&&(b=3);let M=a.attributes.position.count*b,E=1;M>t.maxTextureSize&&(E=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let S=new Float32Array(M*E*4*d),_=new zr(S,M,E,d);_.type=mn,_.needsUpdate=!0;let y=b*4;for(let A=0;A<d;A++){let C=p[A],N=g[A],O=x[A],I=M*E*4*A;for(let k=0;k<C.count;k++){let D=k*y;f===!0&&(s.fromBufferAttribute(C,k),S[I+D+0]=s.x,S[I+D+1]=s.y,S[I+D+2]=s.z,S[I+D+3]=0),m===!0&&(s.fromBufferAttribute(N,k),S[I+D+4]=s.x,S[I+D+5]=s.y,S[I+D+6]=s.z,S[I+D+7]=0),v===!0&&(s.fromBufferAttribute(O,k),S[I+D+8]=s.x,S[I+D+9]=s.y,S[I+D+10]=s.z,S[I+D+11]=O.itemSize===4?s.w:1)}}u={count:d,texture:_,size:new bt(M,E)},n.set(a,u),a.addEventListener("dispose",R)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function by(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,d=c.geometry,u=t.get(c,d);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var wy={[yh]:"LINEAR_TONE_MAPPING",[vh]:"REINHARD_TONE_MAPPING",[Mh]:"CINEON_TONE_MAPPING",[Sh]:"ACES_FILMIC_TONE_MAPPING",[wh]:"AGX_TONE_MAPPING",[Eh]:"NEUTRAL_TONE_MAPPING",[bh]:"CUSTOM_TONE_MAPPING"};function Ey(i,t,e,n,s,r){let o=new bn(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new $e;h.setAttribute("position",new Te([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Te([0,2,0,0,2,0],2));let d=new ka({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new we(h,d),f=new po(-1,1,1,-1,0,1),m=null,v=null,p=!1,g,x=null,b=[],M=!1;this.setSize=function(E,S){o.setSize(E,S),a!==null&&a.setSize(E,S),l!==null&&l.setSize(E,S);for(let _=0;_<b.length;_++){let y=b[_];y.setSize&&y.setSize(E,S)}},this.setEffects=function(E){b=E,M=b.length>0&&b[0].isRenderPass===!0;let S=o.width,_=o.height;b.length>0&&a===null&&(a=new bn(S,_,{type:Hn,depthBuffer:!1,stencilBuffer:!1}),l=new bn(S,_,{type:Hn,depthBuffer:!1,stencilBuffer:!1}));let y=s===!0&&b.some(R=>R.needsDepthTexture===!0);y!==(o.depthTexture!==null)&&(y===!0&&c===null&&(c=new gi(S,_),r===!0&&(c.format=xi,c.type=ps)),o.dispose(),o.depthTexture=y?c:null,o.resolveDepthBuffer=y,o.storeMultisampledDepthBuffer=y);for(let R=0;R<b.length;R++){let A=b[R];A.setSize&&A.setSize(S,_),y&&A.needsDepthTexture===!0&&A.setDepthTexture&&A.setDepthTexture(c)}},this.begin=function(E,S){if(p||E.toneMapping===Kn&&b.length===0)return!1;if(x=S,S!==null){let _=S.width,y=S.height;(o.width!==_||o.height!==y)&&this.setSize(_,y)}return M===!1&&E.setRenderTarget(o),g=E.toneMapping,E.toneMapping=Kn,!0},this.hasRenderPass=function(){return M},this.end=function(E,S){E.toneMapping=g,p=!0;let _=o,y=a;for(let R=0;R<b.length;R++){let A=b[R];A.enabled!==!1&&(A.render(E,y,_,S),A.needsSwap!==!1&&(_=y,y=y===a?l:a))}if(m!==E.outputColorSpace||v!==E.toneMapping){m=E.outputColorSpace,v=E.toneMapping,d.defines={},re.getTransfer(m)===me&&(d.defines.SRGB_TRANSFER="");let R=wy[v];R&&(d.defines[R]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=_.texture,E.setRenderTarget(x),E.render(u,f),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var pp=new cn,mp=new gi(1,1),gp=new Zr(1),_p=new zr,xp=new Ia,yp=new $r,$f=[],Yf=[],Zf=new Float32Array(16),Jf=new Float32Array(9),Kf=new Float32Array(4);function ar(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=$f[s];if(r===void 0&&(r=new Float32Array(s),$f[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Oe(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Fe(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Xl(i,t){let e=Yf[t];e===void 0&&(e=new Int32Array(t),Yf[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function Ay(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function Ty(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Oe(e,t))return;i.uniform2fv(this.addr,t),Fe(e,t)}}function Ry(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Oe(e,t))return;i.uniform3fv(this.addr,t),Fe(e,t)}}function Cy(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Oe(e,t))return;i.uniform4fv(this.addr,t),Fe(e,t)}}function Py(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Oe(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Fe(e,t)}else{if(Oe(e,n))return;Kf.set(n),i.uniformMatrix2fv(this.addr,!1,Kf),Fe(e,n)}}function Iy(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Oe(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Fe(e,t)}else{if(Oe(e,n))return;Jf.set(n),i.uniformMatrix3fv(this.addr,!1,Jf),Fe(e,n)}}function Ly(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Oe(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Fe(e,t)}else{if(Oe(e,n))return;Zf.set(n),i.uniformMatrix4fv(this.addr,!1,Zf),Fe(e,n)}}function Dy(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function Ny(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Oe(e,t))return;i.uniform2iv(this.addr,t),Fe(e,t)}}function Uy(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Oe(e,t))return;i.uniform3iv(this.addr,t),Fe(e,t)}}function Oy(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Oe(e,t))return;i.uniform4iv(this.addr,t),Fe(e,t)}}function Fy(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function By(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Oe(e,t))return;i.uniform2uiv(this.addr,t),Fe(e,t)}}function ky(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Oe(e,t))return;i.uniform3uiv(this.addr,t),Fe(e,t)}}function zy(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Oe(e,t))return;i.uniform4uiv(this.addr,t),Fe(e,t)}}function ql(i){return i.version===0&&(i.compareFunction=Uh,i.needsUpdate=!0),i}function Gy(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=ql(mp):r=pp,e.setTexture2D(t||r,s)}function Hy(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||xp,s)}function Vy(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=ql(gp):r=yp,e.setTextureCube(t||r,s)}function Wy(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||_p,s)}function Xy(i){switch(i){case 5126:return Ay;case 35664:return Ty;case 35665:return Ry;case 35666:return Cy;case 35674:return Py;case 35675:return Iy;case 35676:return Ly;case 5124:case 35670:return Dy;case 35667:case 35671:return Ny;case 35668:case 35672:return Uy;case 35669:case 35673:return Oy;case 5125:return Fy;case 36294:return By;case 36295:return ky;case 36296:return zy;case 35678:case 36198:case 36298:case 36306:case 35682:return Gy;case 35679:case 36299:case 36307:return Hy;case 35680:case 36300:case 36308:case 36293:return Vy;case 36289:case 36303:case 36311:case 36292:return Wy}}function qy(i,t){i.uniform1fv(this.addr,t)}function $y(i,t){let e=ar(t,this.size,2);i.uniform2fv(this.addr,e)}function Yy(i,t){let e=ar(t,this.size,3);i.uniform3fv(this.addr,e)}function Zy(i,t){let e=ar(t,this.size,4);i.uniform4fv(this.addr,e)}function Jy(i,t){let e=ar(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Ky(i,t){let e=ar(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function jy(i,t){let e=ar(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Qy(i,t){i.uniform1iv(this.addr,t)}function tv(i,t){i.uniform2iv(this.addr,t)}function ev(i,t){i.uniform3iv(this.addr,t)}function nv(i,t){i.uniform4iv(this.addr,t)}function iv(i,t){i.uniform1uiv(this.addr,t)}function sv(i,t){i.uniform2uiv(this.addr,t)}function rv(i,t){i.uniform3uiv(this.addr,t)}function ov(i,t){i.uniform4uiv(this.addr,t)}function av(i,t,e){let n=this.cache,s=t.length,r=Xl(e,s);Oe(n,r)||(i.uniform1iv(this.addr,r),Fe(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=ql(mp):o=pp;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function lv(i,t,e){let n=this.cache,s=t.length,r=Xl(e,s);Oe(n,r)||(i.uniform1iv(this.addr,r),Fe(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||xp,r[o])}function cv(i,t,e){let n=this.cache,s=t.length,r=Xl(e,s);Oe(n,r)||(i.uniform1iv(this.addr,r),Fe(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=ql(gp):o=yp;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function hv(i,t,e){let n=this.cache,s=t.length,r=Xl(e,s);Oe(n,r)||(i.uniform1iv(this.addr,r),Fe(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||_p,r[o])}function uv(i){switch(i){case 5126:return qy;case 35664:return $y;case 35665:return Yy;case 35666:return Zy;case 35674:return Jy;case 35675:return Ky;case 35676:return jy;case 5124:case 35670:return Qy;case 35667:case 35671:return tv;case 35668:case 35672:return ev;case 35669:case 35673:return nv;case 5125:return iv;case 36294:return sv;case 36295:return rv;case 36296:return ov;case 35678:case 36198:case 36298:case 36306:case 35682:return av;case 35679:case 36299:case 36307:return lv;case 35680:case 36300:case 36308:case 36293:return cv;case 36289:case 36303:case 36311:case 36292:return hv}}var Zh=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=Xy(e.type)}},Jh=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=uv(e.type)}},Kh=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},$h=/(\w+)(\])?(\[|\.)?/g;function jf(i,t){i.seq.push(t),i.map[t.id]=t}function dv(i,t,e){let n=i.name,s=n.length;for($h.lastIndex=0;;){let r=$h.exec(n),o=$h.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){jf(e,c===void 0?new Zh(a,i,t):new Jh(a,i,t));break}else{let d=e.map[a];d===void 0&&(d=new Kh(a),jf(e,d)),e=d}}}var or=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);dv(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function Qf(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var fv=37297,pv=0;function mv(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var tp=new qt;function gv(i){re._getMatrix(tp,re.workingColorSpace,i);let t=`mat3( ${tp.elements.map(e=>e.toFixed(4))} )`;switch(re.getTransfer(i)){case Br:return[t,"LinearTransferOETF"];case me:return[t,"sRGBTransferOETF"];default:return Gt("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function ep(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+mv(i.getShaderSource(t),a)}else return r}function _v(i,t){let e=gv(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var xv={[yh]:"Linear",[vh]:"Reinhard",[Mh]:"Cineon",[Sh]:"ACESFilmic",[wh]:"AgX",[Eh]:"Neutral",[bh]:"Custom"};function yv(i,t){let e=xv[t];return e===void 0?(Gt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Hl=new q;function vv(){re.getLuminanceCoefficients(Hl);let i=Hl.x.toFixed(4),t=Hl.y.toFixed(4),e=Hl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Mv(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(To).join(`
`)}function Sv(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function bv(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function To(i){return i!==""}function np(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function ip(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var wv=/^[ \t]*#include +<([\w\d./]+)>/gm;function jh(i){return i.replace(wv,Ev)}function Ev(i,t){let e=ne[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return jh(e)}var Av=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function sp(i){return i.replace(Av,Tv)}function Tv(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function rp(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var Rv={[hs]:"SHADOWMAP_TYPE_PCF",[nr]:"SHADOWMAP_TYPE_VSM"};function Cv(i){return Rv[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Pv={[sr]:"ENVMAP_MODE_REFRACTION"};function Iv(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Pv[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Lv={[xh]:"ENVMAP_BLENDING_MULTIPLY",[_f]:"ENVMAP_BLENDING_MIX",[xf]:"ENVMAP_BLENDING_ADD"};function Dv(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Lv[i.combine]||"ENVMAP_BLENDING_NONE"}function Nv(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Cv(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Iv(e),d=Dv(e),u=Mv(e),f=Sv(r),m=s.createProgram(),v,p,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(v=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(To).join(`
`),v.length>0&&(v+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(To).join(`
`),p.length>0&&(p+=`
`)):(v=[rp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(To).join(`
`),p=[rp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Kn?"#define TONE_MAPPING":"",e.toneMapping!==Kn?ne.tonemapping_pars_fragment:"",e.toneMapping!==Kn?yv("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ne.colorspace_pars_fragment,_v("linearToOutputTexel",e.outputColorSpace),vv(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(To).join(`
`)),o=jh(o),o=np(o,e),o=ip(o,e),a=jh(a),a=np(a,e),a=ip(a,e),o=sp(o),a=sp(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,v=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,p=["#define varying in",e.glslVersion===Eo?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Eo?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=g+v+o,b=g+p+a,M=Qf(s,s.VERTEX_SHADER,x),E=Qf(s,s.FRAGMENT_SHADER,b);s.attachShader(m,M),s.attachShader(m,E),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function S(A){if(i.debug.checkShaderErrors){let C=s.getProgramInfoLog(m)||"",N=s.getShaderInfoLog(M)||"",O=s.getShaderInfoLog(E)||"",I=C.trim(),k=N.trim(),D=O.trim(),L=!0,B=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(L=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,M,E);else{let z=ep(s,M,"vertex"),F=ep(s,E,"fragment");Wt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+A.name+`
Material Type: `+A.type+`

Program Info Log: `+I+`
`+z+`
`+F)}else I!==""?Gt("WebGLProgram: Program Info Log:",I):(k===""||D==="")&&(B=!1);B&&(A.diagnostics={runnable:L,programLog:I,vertexShader:{log:k,prefix:v},fragmentShader:{log:D,prefix:p}})}s.deleteShader(M),s.deleteShader(E),_=new or(s,m),y=bv(s,m)}let _;this.getUniforms=function(){return _===void 0&&S(this),_};let y;this.getAttributes=function(){return y===void 0&&S(this),y};let R=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return R===!1&&(R=s.getProgramParameter(m,fv)),R},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=pv++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=M,this.fragmentShader=E,this}var Uv=0,Qh=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new tu(t),e.set(t,n)),n}},tu=class{constructor(t){this.id=Uv++,this.code=t,this.usedTimes=0}};function Ov(i){return i===Hi||i===bo||i===wo}function Fv(i,t,e,n,s,r){let o=new Gr,a=new Qh,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function m(_,y,R,A,C,N){let O=A.fog,I=C.geometry,k=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?A.environment:null,D=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,L=t.get(_.envMap||k,D),B=u[_.type],z=n.precision;_.precision!==null&&(z=n.getMaxPrecision(_.precision),z!==_.precision&&Gt("WebGLProgram.getParameters:",_.precision,"not supported, using",z,"instead."));let F=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,X=F!==void 0?F.length:0,et=0;I.morphAttributes.position!==void 0&&(et=1),I.morphAttributes.normal!==void 0&&(et=2),I.morphAttributes.color!==void 0&&(et=3);let W,U,Q,K;if(B){let wt=Qn[B];W=wt.vertexShader,U=wt.fragmentShader}else{W=_.vertexShader,U=_.fragmentShader;let wt=a.getVertexShaderStage(_),xe=a.getFragmentShaderStage(_);a.update(_,wt,xe),Q=wt.id,K=xe.id}let at=i.getRenderTarget(),ot=i.state.buffers.depth.getReversed(),It=C.isInstancedMesh===!0,Xt=C.isBatchedMesh===!0,Ct=!!_.map,Kt=!!_.matcap,Jt=!!L,Ht=Jt&&L.isPMREMTexture===!0,Mt=!!_.aoMap,Tt=!!_.lightMap,dt=!!_.bumpMap&&_.wireframe===!1,Rt=!!_.normalMap,Vt=!!_.displacementMap,ct=!!_.emissiveMap,Lt=!!_.metalnessMap,Ft=!!_.roughnessMap,Qt=_.anisotropy>0,H=_.clearcoat>0,_e=_.diffuseRoughness>0,ce=_.dispersion>0,pe=_.retroreflectivity>0,Z=_.iridescence>0,Bt=_.sheen>0,yt=_.transmission>0,Pt=Qt&&!!_.anisotropyMap,P=H&&!!_.clearcoatMap,w=H&&!!_.clearcoatNormalMap,$=H&&!!_.clearcoatRoughnessMap,lt=_e&&!!_.diffuseRoughnessMap,nt=Z&&!!_.iridescenceMap,ht=Z&&!!_.iridescenceThicknessMap,mt=Bt&&!!_.sheenColorMap,it=Bt&&!!_.sheenRoughnessMap,st=!!_.specularMap,gt=!!_.specularColorMap,G=!!_.specularIntensityMap,rt=yt&&!!_.transmissionMap,tt=yt&&!!_.thicknessMap,_t=!!_.gradientMap,ft=!!_.alphaMap,pt=_.alphaTest>0,kt=!!_.alphaHash,te=!!_.extensions,ut=Kn;_.toneMapped&&(at===null||at.isXRRenderTarget===!0)&&(ut=i.toneMapping);let zt=Ht?L.isCompressedCubeTexture?L.image[0].mipmaps:L.mipmaps:null,jt={shaderID:B,shaderType:_.type,shaderName:_.name,vertexShader:W,fragmentShader:U,defines:_.defines,customVertexShaderID:Q,customFragmentShaderID:K,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:z,batching:Xt,batchingColor:Xt&&C._colorsTexture!==null,instancing:It,instancingColor:It&&C.instanceColor!==null,instancingMorph:It&&C.morphTexture!==null,outputColorSpace:at===null?i.outputColorSpace:at.isXRRenderTarget===!0?at.texture.colorSpace:re.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Ct,matcap:Kt,envMap:Jt,envMapMode:Jt&&L.mapping,envMapPMREM:Ht,envMapMaxLod:Ht?zt.length-1:null,envMapSize:Ht?zt[0].width:null,aoMap:Mt,lightMap:Tt,bumpMap:dt,normalMap:Rt,displacementMap:Vt,emissiveMap:ct,normalMapObjectSpace:Rt&&_.normalMapType===Mf,normalMapTangentSpace:Rt&&_.normalMapType===zl,packedNormalMap:Rt&&_.normalMapType===zl&&Ov(_.normalMap.format),metalnessMap:Lt,roughnessMap:Ft,anisotropy:Qt,anisotropyMap:Pt,clearcoat:H,clearcoatMap:P,clearcoatNormalMap:w,clearcoatRoughnessMap:$,diffuseRoughness:_e,diffuseRoughnessMap:lt,dispersion:ce,retroreflection:pe,iridescence:Z,iridescenceMap:nt,iridescenceThicknessMap:ht,sheen:Bt,sheenColorMap:mt,sheenRoughnessMap:it,specularMap:st,specularColorMap:gt,specularIntensityMap:G,transmission:yt,transmissionMap:rt,thicknessMap:tt,gradientMap:_t,opaque:_.transparent===!1&&_.blending===ir&&_.alphaToCoverage===!1,alphaMap:ft,alphaTest:pt,alphaHash:kt,combine:_.combine,mapUv:Ct&&f(_.map.channel),aoMapUv:Mt&&f(_.aoMap.channel),lightMapUv:Tt&&f(_.lightMap.channel),bumpMapUv:dt&&f(_.bumpMap.channel),normalMapUv:Rt&&f(_.normalMap.channel),displacementMapUv:Vt&&f(_.displacementMap.channel),emissiveMapUv:ct&&f(_.emissiveMap.channel),metalnessMapUv:Lt&&f(_.metalnessMap.channel),roughnessMapUv:Ft&&f(_.roughnessMap.channel),anisotropyMapUv:Pt&&f(_.anisotropyMap.channel),clearcoatMapUv:P&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:lt&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:nt&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:ht&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:mt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:it&&f(_.sheenRoughnessMap.channel),specularMapUv:st&&f(_.specularMap.channel),specularColorMapUv:gt&&f(_.specularColorMap.channel),specularIntensityMapUv:G&&f(_.specularIntensityMap.channel),transmissionMapUv:rt&&f(_.transmissionMap.channel),thicknessMapUv:tt&&f(_.thicknessMap.channel),alphaMapUv:ft&&f(_.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Rt||Qt),vertexNormals:!!I.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!I.attributes.uv&&(Ct||ft),fog:!!O,useFog:_.fog===!0,fogExp2:!!O&&O.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||I.attributes.normal===void 0&&Rt===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:ot,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:X,morphTextureStride:et,numSunLights:y.sun.length,numDirLights:y.directional.length,numPointLights:y.point.length,numSpotLights:y.spot.length,numSpotLightMaps:y.spotLightMap.length,numRectAreaLights:y.rectArea.length,numHemiLights:y.hemi.length,numSunLightShadows:y.sunShadowMap.length,numDirLightShadows:y.directionalShadowMap.length,numPointLightShadows:y.pointShadowMap.length,numSpotLightShadows:y.spotShadowMap.length,numSpotLightShadowsWithMaps:y.numSpotLightShadowsWithMaps,numLightProbes:y.numLightProbes,numLightProbeGrids:N.filter(wt=>wt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&R.length>0,shadowMapType:i.shadowMap.type,toneMapping:ut,decodeVideoTexture:Ct&&_.map.isVideoTexture===!0&&re.getTransfer(_.map.colorSpace)===me,decodeVideoTextureEmissive:ct&&_.emissiveMap.isVideoTexture===!0&&re.getTransfer(_.emissiveMap.colorSpace)===me,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===Ie,flipSided:_.side===un,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:te&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(te&&_.extensions.multiDraw===!0||Xt)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return jt.vertexUv1s=l.has(1),jt.vertexUv2s=l.has(2),jt.vertexUv3s=l.has(3),l.clear(),jt}function v(_){let y=[];if(_.shaderID?y.push(_.shaderID):(y.push(_.customVertexShaderID),y.push(_.customFragmentShaderID)),_.defines!==void 0)for(let R in _.defines)y.push(R),y.push(_.defines[R]);return _.isRawShaderMaterial===!1&&(p(y,_),g(y,_),y.push(i.outputColorSpace)),y.push(_.customProgramCacheKey),y.join()}function p(_,y){_.push(y.precision),_.push(y.outputColorSpace),_.push(y.envMapMode),_.push(y.envMapPMREM),_.push(y.envMapMaxLod),_.push(y.envMapSize),_.push(y.mapUv),_.push(y.alphaMapUv),_.push(y.lightMapUv),_.push(y.aoMapUv),_.push(y.bumpMapUv),_.push(y.normalMapUv),_.push(y.displacementMapUv),_.push(y.emissiveMapUv),_.push(y.metalnessMapUv),_.push(y.roughnessMapUv),_.push(y.anisotropyMapUv),_.push(y.clearcoatMapUv),_.push(y.clearcoatNormalMapUv),_.push(y.clearcoatRoughnessMapUv),_.push(y.diffuseRoughnessMapUv),_.push(y.iridescenceMapUv),_.push(y.iridescenceThicknessMapUv),_.push(y.sheenColorMapUv),_.push(y.sheenRoughnessMapUv),_.push(y.specularMapUv),_.push(y.specularColorMapUv),_.push(y.specularIntensityMapUv),_.push(y.transmissionMapUv),_.push(y.thicknessMapUv),_.push(y.combine),_.push(y.fogExp2),_.push(y.sizeAttenuation),_.push(y.morphTargetsCount),_.push(y.numSunLights),_.push(y.numDirLights),_.push(y.numPointLights),_.push(y.numSpotLights),_.push(y.numSpotLightMaps),_.push(y.numHemiLights),_.push(y.numRectAreaLights),_.push(y.numSunLightShadows),_.push(y.numDirLightShadows),_.push(y.numPointLightShadows),_.push(y.numSpotLightShadows),_.push(y.numSpotLightShadowsWithMaps),_.push(y.numLightProbes),_.push(y.numLightProbeGrids),_.push(y.shadowMapType),_.push(y.toneMapping),_.push(y.numClippingPlanes),_.push(y.numClipIntersection),_.push(y.depthPacking)}function g(_,y){o.disableAll(),y.instancing&&o.enable(0),y.instancingColor&&o.enable(1),y.instancingMorph&&o.enable(2),y.matcap&&o.enable(3),y.envMap&&o.enable(4),y.normalMapObjectSpace&&o.enable(5),y.normalMapTangentSpace&&o.enable(6),y.clearcoat&&o.enable(7),y.iridescence&&o.enable(8),y.alphaTest&&o.enable(9),y.vertexColors&&o.enable(10),y.vertexAlphas&&o.enable(11),y.vertexUv1s&&o.enable(12),y.vertexUv2s&&o.enable(13),y.vertexUv3s&&o.enable(14),y.vertexTangents&&o.enable(15),y.anisotropy&&o.enable(16),y.alphaHash&&o.enable(17),y.batching&&o.enable(18),y.dispersion&&o.enable(19),y.retroreflection&&o.enable(24),y.diffuseRoughness&&o.enable(25),y.batchingColor&&o.enable(20),y.gradientMap&&o.enable(21),y.packedNormalMap&&o.enable(22),y.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),y.fog&&o.enable(0),y.useFog&&o.enable(1),y.flatShading&&o.enable(2),y.logarithmicDepthBuffer&&o.enable(3),y.reversedDepthBuffer&&o.enable(4),y.skinning&&o.enable(5),y.morphTargets&&o.enable(6),y.morphNormals&&o.enable(7),y.morphColors&&o.enable(8),y.premultipliedAlpha&&o.enable(9),y.shadowMapEnabled&&o.enable(10),y.doubleSided&&o.enable(11),y.flipSided&&o.enable(12),y.useDepthPacking&&o.enable(13),y.dithering&&o.enable(14),y.transmission&&o.enable(15),y.sheen&&o.enable(16),y.opaque&&o.enable(17),y.pointsUvs&&o.enable(18),y.decodeVideoTexture&&o.enable(19),y.decodeVideoTextureEmissive&&o.enable(20),y.alphaToCoverage&&o.enable(21),y.numLightProbeGrids>0&&o.enable(22),y.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function x(_){let y=u[_.type],R;if(y){let A=Qn[y];R=zf.clone(A.uniforms)}else R=_.uniforms;return R}function b(_,y){let R=h.get(y);return R!==void 0?++R.usedTimes:(R=new Nv(i,y,_,s),c.push(R),h.set(y,R)),R}function M(_){if(--_.usedTimes===0){let y=c.indexOf(_);c[y]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function E(_){a.remove(_)}function S(){a.dispose()}return{getParameters:m,getProgramCacheKey:v,getUniforms:x,acquireProgram:b,releaseProgram:M,releaseShaderCache:E,programs:c,dispose:S}}function Bv(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function kv(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function op(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function ap(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,m,v,p,g){let x=i[t];return x===void 0?(x={id:u.id,object:u,geometry:f,material:m,materialVariant:o(u),groupOrder:v,renderOrder:u.renderOrder,z:p,group:g},i[t]=x):(x.id=u.id,x.object=u,x.geometry=f,x.material=m,x.materialVariant=o(u),x.groupOrder=v,x.renderOrder=u.renderOrder,x.z=p,x.group=g),t++,x}function l(u,f,m,v,p,g,x){x.reversedDepth===!0&&(p=-p);let b=a(u,f,m,v,p,g);m.transmission>0?n.push(b):m.transparent===!0?s.push(b):e.push(b)}function c(u,f,m,v,p,g){let x=a(u,f,m,v,p,g);m.transmission>0?n.unshift(x):m.transparent===!0?s.unshift(x):e.unshift(x)}function h(u,f){e.length>1&&e.sort(u||kv),n.length>1&&n.sort(f||op),s.length>1&&s.sort(f||op)}function d(){for(let u=t,f=i.length;u<f;u++){let m=i[u];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function zv(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new ap,i.set(n,[o])):s>=r.length?(o=new ap,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function Gv(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new q,color:new Yt};break;case"SpotLight":e={position:new q,direction:new q,color:new Yt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new q,color:new Yt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new q,skyColor:new Yt,groundColor:new Yt};break;case"RectAreaLight":e={color:new Yt,position:new q,halfWidth:new q,halfHeight:new q};break}return i[t.id]=e,e}}}function Hv(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new bt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new bt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new bt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var Vv=0;function Wv(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function Xv(i){let t=new Gv,e=Hv(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new q);let s=new q,r=new ge,o=new ge;function a(c){let h=0,d=0,u=0;for(let N=0;N<9;N++)n.probe[N].set(0,0,0);let f=0,m=0,v=0,p=0,g=0,x=0,b=0,M=0,E=0,S=0,_=0,y=0,R=0,A=0;c.sort(Wv);for(let N=0,O=c.length;N<O;N++){let I=c[N],k=I.color,D=I.intensity,L=I.distance,B=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Hi?B=I.shadow.map.texture:B=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=k.r*D,d+=k.g*D,u+=k.b*D;else if(I.isLightProbe){for(let z=0;z<9;z++)n.probe[z].addScaledVector(I.sh.coefficients[z],D);A++}else if(I.isSunLight){let z=t.get(I);if(z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let F=I.shadow,X=e.get(I);X.shadowIntensity=F.intensity,X.shadowBias=F.bias,X.shadowNormalBias=F.normalBias,X.shadowRadius=F.radius,X.shadowMapSize.copy(F.mapSize).multiply(F.getFrameExtents()),n.sunShadow[m]=X,n.sunShadowMap[m]=B;let et=F.getViewportCount();for(let W=0;W<et;W++)n.sunShadowMatrix[v+W]=F.getMatrix(W),n.sunShadowCascade[v+W]=F._cascadeData[W];v+=et,m++}n.sun[f]=z,f++}else if(I.isDirectionalLight){let z=t.get(I);if(z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let F=I.shadow,X=e.get(I);X.shadowIntensity=F.intensity,X.shadowBias=F.bias,X.shadowNormalBias=F.normalBias,X.shadowRadius=F.radius,X.shadowMapSize=F.mapSize,n.directionalShadow[p]=X,n.directionalShadowMap[p]=B,n.directionalShadowMatrix[p]=I.shadow.matrix,E++}n.directional[p]=z,p++}else if(I.isSpotLight){let z=t.get(I);z.position.setFromMatrixPosition(I.matrixWorld),z.color.copy(k).multiplyScalar(D),z.distance=L,z.coneCos=Math.cos(I.angle),z.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),z.decay=I.decay,n.spot[x]=z;let F=I.shadow;if(I.map&&(n.spotLightMap[y]=I.map,y++,F.updateMatrices(I),I.castShadow&&R++),n.spotLightMatrix[x]=F.matrix,I.castShadow){let X=e.get(I);X.shadowIntensity=F.intensity,X.shadowBias=F.bias,X.shadowNormalBias=F.normalBias,X.shadowRadius=F.radius,X.shadowMapSize=F.mapSize,n.spotShadow[x]=X,n.spotShadowMap[x]=B,_++}x++}else if(I.isRectAreaLight){let z=t.get(I);z.color.copy(k).multiplyScalar(D),z.halfWidth.set(I.width*.5,0,0),z.halfHeight.set(0,I.height*.5,0),n.rectArea[b]=z,b++}else if(I.isPointLight){let z=t.get(I);if(z.color.copy(I.color).multiplyScalar(I.intensity),z.distance=I.distance,z.decay=I.decay,I.castShadow){let F=I.shadow,X=e.get(I);X.shadowIntensity=F.intensity,X.shadowBias=F.bias,X.shadowNormalBias=F.normalBias,X.shadowRadius=F.radius,X.shadowMapSize=F.mapSize,X.shadowCameraNear=F.camera.near,X.shadowCameraFar=F.camera.far,n.pointShadow[g]=X,n.pointShadowMap[g]=B,n.pointShadowMatrix[g]=I.shadow.matrix,S++}n.point[g]=z,g++}else if(I.isHemisphereLight){let z=t.get(I);z.skyColor.copy(I.color).multiplyScalar(D),z.groundColor.copy(I.groundColor).multiplyScalar(D),n.hemi[M]=z,M++}}b>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Et.LTC_FLOAT_1,n.rectAreaLTC2=Et.LTC_FLOAT_2):(n.rectAreaLTC1=Et.LTC_HALF_1,n.rectAreaLTC2=Et.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;let C=n.hash;(C.sunLength!==f||C.directionalLength!==p||C.pointLength!==g||C.spotLength!==x||C.rectAreaLength!==b||C.hemiLength!==M||C.numSunShadows!==m||C.numDirectionalShadows!==E||C.numPointShadows!==S||C.numSpotShadows!==_||C.numSpotMaps!==y||C.numLightProbes!==A)&&(n.sun.length=f,n.directional.length=p,n.spot.length=x,n.rectArea.length=b,n.point.length=g,n.hemi.length=M,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.directionalShadowMatrix.length=E,n.pointShadow.length=S,n.pointShadowMap.length=S,n.pointShadowMatrix.length=S,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+y-R,n.spotLightMap.length=y,n.numSpotLightShadowsWithMaps=R,n.numLightProbes=A,C.sunLength=f,C.directionalLength=p,C.pointLength=g,C.spotLength=x,C.rectAreaLength=b,C.hemiLength=M,C.numSunShadows=m,C.numDirectionalShadows=E,C.numPointShadows=S,C.numSpotShadows=_,C.numSpotMaps=y,C.numLightProbes=A,n.version=Vv++)}function l(c,h){let d=0,u=0,f=0,m=0,v=0,p=0,g=h.matrixWorldInverse;for(let x=0,b=c.length;x<b;x++){let M=c[x];if(M.isSunLight){let E=n.sun[d];E.direction.setFromMatrixPosition(M.matrixWorld),E.direction.transformDirection(g),d++}else if(M.isDirectionalLight){let E=n.directional[u];E.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),u++}else if(M.isSpotLight){let E=n.spot[m];E.position.setFromMatrixPosition(M.matrixWorld),E.position.applyMatrix4(g),E.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(g),m++}else if(M.isRectAreaLight){let E=n.rectArea[v];E.position.setFromMatrixPosition(M.matrixWorld),E.position.applyMatrix4(g),o.identity(),r.copy(M.matrixWorld),r.premultiply(g),o.extractRotation(r),E.halfWidth.set(M.width*.5,0,0),E.halfHeight.set(0,M.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),v++}else if(M.isPointLight){let E=n.point[f];E.position.setFromMatrixPosition(M.matrixWorld),E.position.applyMatrix4(g),f++}else if(M.isHemisphereLight){let E=n.hemi[p];E.direction.setFromMatrixPosition(M.matrixWorld),E.direction.transformDirection(g),p++}}}return{setup:a,setupView:l,state:n}}function lp(i){let t=new Xv(i),e=[],n=[],s=[];function r(d){h.camera=d,e.length=0,n.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){n.push(d)}function l(){t.setup(e),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){t.setupView(e,d)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function qv(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new lp(i),t.set(s,[a])):r>=o.length?(a=new lp(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var $v=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Yv=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Zv=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],Jv=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],cp=new ge,Ao=new q,Yh=new q;function Kv(i,t,e){let n=new Ui,s=new bt,r=new bt,o=new be,a=new za,l=new Ga,c={},h=e.maxTextureSize,d={[Jn]:un,[un]:Jn,[Ie]:Ie},u=new In({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new bt},radius:{value:4}},vertexShader:$v,fragmentShader:Yv}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let m=new $e;m.setAttribute("position",new Ue(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new we(m,u),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=hs;let g=this.type;this.render=function(S,_,y){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||S.length===0)return;this.type===Kd&&(Gt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=hs);let R=i.getRenderTarget(),A=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),N=i.state;N.setBlending(us),N.buffers.depth.getReversed()===!0?N.buffers.color.setClear(0,0,0,0):N.buffers.color.setClear(1,1,1,1),N.buffers.depth.setTest(!0),N.setScissorTest(!1);let O=g!==this.type;O&&_.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(k=>k.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,k=S.length;I<k;I++){let D=S[I],L=D.shadow;if(L===void 0){Gt("WebGLShadowMap:",D,"has no shadow.");continue}if(L.autoUpdate===!1&&L.needsUpdate===!1)continue;s.copy(L.mapSize);let B=L.getFrameExtents();s.multiply(B),r.copy(L.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/B.x),s.x=r.x*B.x,L.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/B.y),s.y=r.y*B.y,L.mapSize.y=r.y));let z=i.state.buffers.depth.getReversed();if(L.camera._reversedDepth=z,L.map===null||O===!0){if(L.map!==null&&(L.map.depthTexture!==null&&(L.map.depthTexture.dispose(),L.map.depthTexture=null),L.map.dispose()),this.type===nr){if(D.isPointLight){Gt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}L.map=new bn(s.x,s.y,{format:Hi,type:Hn,minFilter:ln,magFilter:ln,generateMipmaps:!1}),L.map.texture.name=D.name+".shadowMap",L.map.depthTexture=new gi(s.x,s.y,mn),L.map.depthTexture.name=D.name+".shadowMapDepth",L.map.depthTexture.format=fi,L.map.depthTexture.compareFunction=null,L.map.depthTexture.minFilter=Xe,L.map.depthTexture.magFilter=Xe}else D.isPointLight?(L.map=new Ro(s.x),L.map.depthTexture=new Zr(s.x,Gn)):(L.map=new bn(s.x,s.y),L.map.depthTexture=new gi(s.x,s.y,Gn)),L.map.depthTexture.name=D.name+".shadowMap",L.map.depthTexture.format=fi,this.type===hs?(L.map.depthTexture.compareFunction=z?Nh:Dh,L.map.depthTexture.minFilter=ln,L.map.depthTexture.magFilter=ln):(L.map.depthTexture.compareFunction=null,L.map.depthTexture.minFilter=Xe,L.map.depthTexture.magFilter=Xe);L.camera.updateProjectionMatrix()}L.map.isWebGLCubeRenderTarget!==!0&&(L.map.width!==s.x||L.map.height!==s.y)&&L.map.setSize(s.x,s.y);let F=L.map.isWebGLCubeRenderTarget?6:L.getViewportCount();D.isPointLight!==!0&&L.updateMatrices(D,y);let X=(L.camera.layers.mask&4294967294)!==0?L.camera.layers:y.layers;for(let et=0;et<F;et++){let W=L.getCamera(et);if(D.isPointLight){let U=L.camera,Q=L.matrix,K=D.distance||U.far;K!==U.far&&(U.far=K,U.updateProjectionMatrix()),Ao.setFromMatrixPosition(D.matrixWorld),U.position.copy(Ao),Yh.copy(U.position),Yh.add(Zv[et]),U.up.copy(Jv[et]),U.lookAt(Yh),U.updateMatrixWorld(),Q.makeTranslation(-Ao.x,-Ao.y,-Ao.z),cp.multiplyMatrices(U.projectionMatrix,U.matrixWorldInverse),L._frustum.setFromProjectionMatrix(cp,U.coordinateSystem,U.reversedDepth)}if(L.map.isWebGLCubeRenderTarget)i.setRenderTarget(L.map,et),i.clear();else{et===0&&(i.setRenderTarget(L.map),i.clear());let U=L.getViewport(et);o.set(r.x*U.x,r.y*U.y,r.x*U.z,r.y*U.w),N.viewport(o)}n=L.getFrustum(et),M(_,y,W,D,X,this.type)}L.isPointLightShadow!==!0&&this.type===nr&&x(L,y),L.needsUpdate=!1}g=this.type,p.needsUpdate=!1,i.setRenderTarget(R,A,C)};function x(S,_){let y=t.update(v);u.defines.VSM_SAMPLES!==S.blurSamples&&(u.defines.VSM_SAMPLES=S.blurSamples,f.defines.VSM_SAMPLES=S.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),S.mapPass===null?S.mapPass=new bn(s.x,s.y,{format:Hi,type:Hn}):(S.mapPass.width!==S.map.width||S.mapPass.height!==S.map.height)&&S.mapPass.setSize(S.map.width,S.map.height),u.uniforms.shadow_pass.value=S.map.depthTexture,u.uniforms.resolution.value.set(S.map.width,S.map.height),u.uniforms.radius.value=S.radius,i.setRenderTarget(S.mapPass),i.clear(),i.renderBufferDirect(_,null,y,u,v,null),f.uniforms.shadow_pass.value=S.mapPass.texture,f.uniforms.resolution.value.set(S.map.width,S.map.height),f.uniforms.radius.value=S.radius,i.setRenderTarget(S.map),i.clear(),i.renderBufferDirect(_,null,y,f,v,null)}function b(S,_,y,R){let A=null,C=y.isPointLight===!0?S.customDistanceMaterial:S.customDepthMaterial;if(C!==void 0)A=C;else if(A=y.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let N=A.uuid,O=_.uuid,I=c[N];I===void 0&&(I={},c[N]=I);let k=I[O];k===void 0&&(k=A.clone(),I[O]=k,_.addEventListener("dispose",E)),A=k}if(A.visible=_.visible,A.wireframe=_.wireframe,R===nr?A.side=_.shadowSide!==null?_.shadowSide:_.side:A.side=_.shadowSide!==null?_.shadowSide:d[_.side],A.alphaMap=_.alphaMap,A.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,A.map=_.map,A.clipShadows=_.clipShadows,A.clippingPlanes=_.clippingPlanes,A.clipIntersection=_.clipIntersection,A.displacementMap=_.displacementMap,A.displacementScale=_.displacementScale,A.displacementBias=_.displacementBias,A.wireframeLinewidth=_.wireframeLinewidth,A.linewidth=_.linewidth,y.isPointLight===!0&&A.isMeshDistanceMaterial===!0){let N=i.properties.get(A);N.light=y}return A}function M(S,_,y,R,A,C){if(S.visible===!1)return;if(S.layers.test(A)&&(S.isMesh||S.isLine||S.isPoints)&&(S.castShadow||S.receiveShadow&&C===nr)&&(!S.frustumCulled||S.intersectsFrustum(n))){S.modelViewMatrix.multiplyMatrices(y.matrixWorldInverse,S.matrixWorld);let I=t.update(S),k=S.material;if(Array.isArray(k)){let D=I.groups;for(let L=0,B=D.length;L<B;L++){let z=D[L],F=k[z.materialIndex];if(F&&F.visible){let X=b(S,F,R,C);S.onBeforeShadow(i,S,_,y,I,X,z),i.renderBufferDirect(y,null,I,X,S,z),S.onAfterShadow(i,S,_,y,I,X,z)}}}else if(k.visible){let D=b(S,k,R,C);S.onBeforeShadow(i,S,_,y,I,D,null),i.renderBufferDirect(y,null,I,D,S,null),S.onAfterShadow(i,S,_,y,I,D,null)}}let O=S.children;for(let I=0,k=O.length;I<k;I++)M(O[I],_,y,R,A,C)}function E(S){S.target.removeEventListener("dispose",E);for(let y in c){let R=c[y],A=S.target.uuid;A in R&&(R[A].dispose(),delete R[A])}}}function jv(i,t){function e(){let G=!1,rt=new be,tt=null,_t=new be(0,0,0,0);return{setMask:function(ft){tt!==ft&&!G&&(i.colorMask(ft,ft,ft,ft),tt=ft)},setLocked:function(ft){G=ft},setClear:function(ft,pt,kt,te,ut){ut===!0&&(ft*=te,pt*=te,kt*=te),rt.set(ft,pt,kt,te),_t.equals(rt)===!1&&(i.clearColor(ft,pt,kt,te),_t.copy(rt))},reset:function(){G=!1,tt=null,_t.set(-1,0,0,0)}}}function n(){let G=!1,rt=!1,tt=null,_t=null,ft=null;return{setReversed:function(pt){if(rt!==pt){let kt=t.get("EXT_clip_control");pt?kt.clipControlEXT(kt.LOWER_LEFT_EXT,kt.ZERO_TO_ONE_EXT):kt.clipControlEXT(kt.LOWER_LEFT_EXT,kt.NEGATIVE_ONE_TO_ONE_EXT),rt=pt;let te=ft;ft=null,this.setClear(te)}},getReversed:function(){return rt},setTest:function(pt){pt?ot(i.DEPTH_TEST):It(i.DEPTH_TEST)},setMask:function(pt){tt!==pt&&!G&&(i.depthMask(pt),tt=pt)},setFunc:function(pt){if(rt&&(pt=Lf[pt]),_t!==pt){switch(pt){case va:i.depthFunc(i.NEVER);break;case Ma:i.depthFunc(i.ALWAYS);break;case Sa:i.depthFunc(i.LESS);break;case Hs:i.depthFunc(i.LEQUAL);break;case ba:i.depthFunc(i.EQUAL);break;case wa:i.depthFunc(i.GEQUAL);break;case Ea:i.depthFunc(i.GREATER);break;case Aa:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}_t=pt}},setLocked:function(pt){G=pt},setClear:function(pt){ft!==pt&&(ft=pt,rt&&(pt=1-pt),i.clearDepth(pt))},reset:function(){G=!1,tt=null,_t=null,ft=null,rt=!1}}}function s(){let G=!1,rt=null,tt=null,_t=null,ft=null,pt=null,kt=null,te=null,ut=null;return{setTest:function(zt){G||(zt?ot(i.STENCIL_TEST):It(i.STENCIL_TEST))},setMask:function(zt){rt!==zt&&!G&&(i.stencilMask(zt),rt=zt)},setFunc:function(zt,jt,wt){(tt!==zt||_t!==jt||ft!==wt)&&(i.stencilFunc(zt,jt,wt),tt=zt,_t=jt,ft=wt)},setOp:function(zt,jt,wt){(pt!==zt||kt!==jt||te!==wt)&&(i.stencilOp(zt,jt,wt),pt=zt,kt=jt,te=wt)},setLocked:function(zt){G=zt},setClear:function(zt){ut!==zt&&(i.clearStencil(zt),ut=zt)},reset:function(){G=!1,rt=null,tt=null,_t=null,ft=null,pt=null,kt=null,te=null,ut=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},d={},u={},f=new WeakMap,m=[],v=null,p=!1,g=null,x=null,b=null,M=null,E=null,S=null,_=null,y=new Yt(0,0,0),R=0,A=!1,C=null,N=null,O=null,I=null,k=null,D=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),L=!1,B=0,z=i.getParameter(i.VERSION);z.indexOf("WebGL")!==-1?(B=parseFloat(/^WebGL (\d)/.exec(z)[1]),L=B>=1):z.indexOf("OpenGL ES")!==-1&&(B=parseFloat(/^OpenGL ES (\d)/.exec(z)[1]),L=B>=2);let F=null,X={},et=i.getParameter(i.SCISSOR_BOX),W=i.getParameter(i.VIEWPORT),U=new be().fromArray(et),Q=new be().fromArray(W);function K(G,rt,tt,_t){let ft=new Uint8Array(4),pt=i.createTexture();i.bindTexture(G,pt),i.texParameteri(G,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(G,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let kt=0;kt<tt;kt++)G===i.TEXTURE_3D||G===i.TEXTURE_2D_ARRAY?i.texImage3D(rt,0,i.RGBA,1,1,_t,0,i.RGBA,i.UNSIGNED_BYTE,ft):i.texImage2D(rt+kt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ft);return pt}let at={};at[i.TEXTURE_2D]=K(i.TEXTURE_2D,i.TEXTURE_2D,1),at[i.TEXTURE_CUBE_MAP]=K(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),at[i.TEXTURE_2D_ARRAY]=K(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),at[i.TEXTURE_3D]=K(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ot(i.DEPTH_TEST),o.setFunc(Hs),dt(!1),Rt(dh),ot(i.CULL_FACE),Mt(us);function ot(G){h[G]!==!0&&(i.enable(G),h[G]=!0)}function It(G){h[G]!==!1&&(i.disable(G),h[G]=!1)}function Xt(G,rt){return u[G]!==rt?(i.bindFramebuffer(G,rt),u[G]=rt,G===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=rt),G===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=rt),!0):!1}function Ct(G,rt){let tt=m,_t=!1;if(G){tt=f.get(rt),tt===void 0&&(tt=[],f.set(rt,tt));let ft=G.textures;if(tt.length!==ft.length||tt[0]!==i.COLOR_ATTACHMENT0){for(let pt=0,kt=ft.length;pt<kt;pt++)tt[pt]=i.COLOR_ATTACHMENT0+pt;tt.length=ft.length,_t=!0}}else tt[0]!==i.BACK&&(tt[0]=i.BACK,_t=!0);_t&&i.drawBuffers(tt)}function Kt(G){return v!==G?(i.useProgram(G),v=G,!0):!1}let Jt={[ds]:i.FUNC_ADD,[Qd]:i.FUNC_SUBTRACT,[tf]:i.FUNC_REVERSE_SUBTRACT};Jt[ef]=i.MIN,Jt[nf]=i.MAX;let Ht={[sf]:i.ZERO,[rf]:i.ONE,[of]:i.SRC_COLOR,[gh]:i.SRC_ALPHA,[df]:i.SRC_ALPHA_SATURATE,[hf]:i.DST_COLOR,[lf]:i.DST_ALPHA,[af]:i.ONE_MINUS_SRC_COLOR,[_h]:i.ONE_MINUS_SRC_ALPHA,[uf]:i.ONE_MINUS_DST_COLOR,[cf]:i.ONE_MINUS_DST_ALPHA,[ff]:i.CONSTANT_COLOR,[pf]:i.ONE_MINUS_CONSTANT_COLOR,[mf]:i.CONSTANT_ALPHA,[gf]:i.ONE_MINUS_CONSTANT_ALPHA};function Mt(G,rt,tt,_t,ft,pt,kt,te,ut,zt){if(G===us){p===!0&&(It(i.BLEND),p=!1);return}if(p===!1&&(ot(i.BLEND),p=!0),G!==jd){if(G!==g||zt!==A){if((x!==ds||E!==ds)&&(i.blendEquation(i.FUNC_ADD),x=ds,E=ds),zt)switch(G){case ir:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case fh:i.blendFunc(i.ONE,i.ONE);break;case ph:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case mh:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Wt("WebGLState: Invalid blending: ",G);break}else switch(G){case ir:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case fh:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case ph:Wt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case mh:Wt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Wt("WebGLState: Invalid blending: ",G);break}b=null,M=null,S=null,_=null,y.set(0,0,0),R=0,g=G,A=zt}return}ft=ft||rt,pt=pt||tt,kt=kt||_t,(rt!==x||ft!==E)&&(i.blendEquationSeparate(Jt[rt],Jt[ft]),x=rt,E=ft),(tt!==b||_t!==M||pt!==S||kt!==_)&&(i.blendFuncSeparate(Ht[tt],Ht[_t],Ht[pt],Ht[kt]),b=tt,M=_t,S=pt,_=kt),(te.equals(y)===!1||ut!==R)&&(i.blendColor(te.r,te.g,te.b,ut),y.copy(te),R=ut),g=G,A=!1}function Tt(G,rt){G.side===Ie?It(i.CULL_FACE):ot(i.CULL_FACE);let tt=G.side===un;rt&&(tt=!tt),dt(tt),G.blending===ir&&G.transparent===!1?Mt(us):Mt(G.blending,G.blendEquation,G.blendSrc,G.blendDst,G.blendEquationAlpha,G.blendSrcAlpha,G.blendDstAlpha,G.blendColor,G.blendAlpha,G.premultipliedAlpha),o.setFunc(G.depthFunc),o.setTest(G.depthTest),o.setMask(G.depthWrite),r.setMask(G.colorWrite);let _t=G.stencilWrite;a.setTest(_t),_t&&(a.setMask(G.stencilWriteMask),a.setFunc(G.stencilFunc,G.stencilRef,G.stencilFuncMask),a.setOp(G.stencilFail,G.stencilZFail,G.stencilZPass)),ct(G.polygonOffset,G.polygonOffsetFactor,G.polygonOffsetUnits),G.alphaToCoverage===!0?ot(i.SAMPLE_ALPHA_TO_COVERAGE):It(i.SAMPLE_ALPHA_TO_COVERAGE)}function dt(G){C!==G&&(G?i.frontFace(i.CW):i.frontFace(i.CCW),C=G)}function Rt(G){G!==Zd?(ot(i.CULL_FACE),G!==N&&(G===dh?i.cullFace(i.BACK):G===Jd?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):It(i.CULL_FACE),N=G}function Vt(G){G!==O&&(L&&i.lineWidth(G),O=G)}function ct(G,rt,tt){G?(ot(i.POLYGON_OFFSET_FILL),(I!==rt||k!==tt)&&(I=rt,k=tt,o.getReversed()&&(rt=-rt,tt=-tt),i.polygonOffset(rt,tt))):It(i.POLYGON_OFFSET_FILL)}function Lt(G){G?ot(i.SCISSOR_TEST):It(i.SCISSOR_TEST)}function Ft(G){G===void 0&&(G=i.TEXTURE0+D-1),F!==G&&(i.activeTexture(G),F=G)}function Qt(G,rt,tt){tt===void 0&&(F===null?tt=i.TEXTURE0+D-1:tt=F);let _t=X[tt];_t===void 0&&(_t={type:void 0,texture:void 0},X[tt]=_t),(_t.type!==G||_t.texture!==rt)&&(F!==tt&&(i.activeTexture(tt),F=tt),i.bindTexture(G,rt||at[G]),_t.type=G,_t.texture=rt)}function H(){let G=X[F];G!==void 0&&G.type!==void 0&&(i.bindTexture(G.type,null),G.type=void 0,G.texture=void 0)}function _e(){try{i.compressedTexImage2D(...arguments)}catch(G){Wt("WebGLState:",G)}}function ce(){try{i.compressedTexImage3D(...arguments)}catch(G){Wt("WebGLState:",G)}}function pe(){try{i.texSubImage2D(...arguments)}catch(G){Wt("WebGLState:",G)}}function Z(){try{i.texSubImage3D(...arguments)}catch(G){Wt("WebGLState:",G)}}function Bt(){try{i.compressedTexSubImage2D(...arguments)}catch(G){Wt("WebGLState:",G)}}function yt(){try{i.compressedTexSubImage3D(...arguments)}catch(G){Wt("WebGLState:",G)}}function Pt(){try{i.texStorage2D(...arguments)}catch(G){Wt("WebGLState:",G)}}function P(){try{i.texStorage3D(...arguments)}catch(G){Wt("WebGLState:",G)}}function w(){try{i.texImage2D(...arguments)}catch(G){Wt("WebGLState:",G)}}function $(){try{i.texImage3D(...arguments)}catch(G){Wt("WebGLState:",G)}}function lt(G){return d[G]!==void 0?d[G]:i.getParameter(G)}function nt(G,rt){d[G]!==rt&&(i.pixelStorei(G,rt),d[G]=rt)}function ht(G){U.equals(G)===!1&&(i.scissor(G.x,G.y,G.z,G.w),U.copy(G))}function mt(G){Q.equals(G)===!1&&(i.viewport(G.x,G.y,G.z,G.w),Q.copy(G))}function it(G,rt){let tt=c.get(rt);tt===void 0&&(tt=new WeakMap,c.set(rt,tt));let _t=tt.get(G);_t===void 0&&(_t=i.getUniformBlockIndex(rt,G.name),i.uniformBlockBinding(rt,_t,_t),tt.set(G,_t))}function st(G,rt,tt){let ft=c.get(rt).get(G);l[ft]!==tt&&(i.bindBufferBase(i.UNIFORM_BUFFER,ft,tt),l[ft]=tt)}function gt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},F=null,X={},u={},l={},f=new WeakMap,m=[],v=null,p=!1,g=null,x=null,b=null,M=null,E=null,S=null,_=null,y=new Yt(0,0,0),R=0,A=!1,C=null,N=null,O=null,I=null,k=null,U.set(0,0,i.canvas.width,i.canvas.height),Q.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ot,disable:It,bindFramebuffer:Xt,drawBuffers:Ct,useProgram:Kt,setBlending:Mt,setMaterial:Tt,setFlipSided:dt,setCullFace:Rt,setLineWidth:Vt,setPolygonOffset:ct,setScissorTest:Lt,activeTexture:Ft,bindTexture:Qt,unbindTexture:H,compressedTexImage2D:_e,compressedTexImage3D:ce,texImage2D:w,texImage3D:$,pixelStorei:nt,getParameter:lt,updateUBOMapping:it,uniformBlockBinding:st,texStorage2D:Pt,texStorage3D:P,texSubImage2D:pe,texSubImage3D:Z,compressedTexSubImage2D:Bt,compressedTexSubImage3D:yt,scissor:ht,viewport:mt,reset:gt}}function Qv(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new bt,h=new WeakMap,d=new Set,u,f=new WeakMap,m=new Set,v=new FinalizationRegistry(P=>m.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,w){return p?new OffscreenCanvas(P,w):kr("canvas")}function x(P,w,$){let lt=1,nt=Pt(P);if((nt.width>$||nt.height>$)&&(lt=$/Math.max(nt.width,nt.height)),lt<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let ht=Math.floor(lt*nt.width),mt=Math.floor(lt*nt.height);u===void 0&&(u=g(ht,mt));let it=w?g(ht,mt):u;return it.width=ht,it.height=mt,it.getContext("2d").drawImage(P,0,0,ht,mt),Gt("WebGLRenderer: Texture has been resized from ("+nt.width+"x"+nt.height+") to ("+ht+"x"+mt+")."),it}else return"data"in P&&Gt("WebGLRenderer: Image in DataTexture is too big ("+nt.width+"x"+nt.height+")."),P;return P}function b(P){return P.generateMipmaps}function M(P){i.generateMipmap(P)}function E(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function S(P,w,$,lt,nt,ht=!1){if(P!==null){if(i[P]!==void 0)return i[P];Gt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let mt;lt&&(mt=t.get("EXT_texture_norm16"),mt||Gt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let it=w;if(w===i.RED&&($===i.FLOAT&&(it=i.R32F),$===i.HALF_FLOAT&&(it=i.R16F),$===i.UNSIGNED_BYTE&&(it=i.R8),$===i.UNSIGNED_SHORT&&mt&&(it=mt.R16_EXT),$===i.SHORT&&mt&&(it=mt.R16_SNORM_EXT)),w===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(it=i.R8UI),$===i.UNSIGNED_SHORT&&(it=i.R16UI),$===i.UNSIGNED_INT&&(it=i.R32UI),$===i.BYTE&&(it=i.R8I),$===i.SHORT&&(it=i.R16I),$===i.INT&&(it=i.R32I)),w===i.RG&&($===i.FLOAT&&(it=i.RG32F),$===i.HALF_FLOAT&&(it=i.RG16F),$===i.UNSIGNED_BYTE&&(it=i.RG8),$===i.UNSIGNED_SHORT&&mt&&(it=mt.RG16_EXT),$===i.SHORT&&mt&&(it=mt.RG16_SNORM_EXT)),w===i.RG_INTEGER&&($===i.UNSIGNED_BYTE&&(it=i.RG8UI),$===i.UNSIGNED_SHORT&&(it=i.RG16UI),$===i.UNSIGNED_INT&&(it=i.RG32UI),$===i.BYTE&&(it=i.RG8I),$===i.SHORT&&(it=i.RG16I),$===i.INT&&(it=i.RG32I)),w===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(it=i.RGB8UI),$===i.UNSIGNED_SHORT&&(it=i.RGB16UI),$===i.UNSIGNED_INT&&(it=i.RGB32UI),$===i.BYTE&&(it=i.RGB8I),$===i.SHORT&&(it=i.RGB16I),$===i.INT&&(it=i.RGB32I)),w===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(it=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(it=i.RGBA16UI),$===i.UNSIGNED_INT&&(it=i.RGBA32UI),$===i.BYTE&&(it=i.RGBA8I),$===i.SHORT&&(it=i.RGBA16I),$===i.INT&&(it=i.RGBA32I)),w===i.RGB&&($===i.UNSIGNED_SHORT&&mt&&(it=mt.RGB16_EXT),$===i.SHORT&&mt&&(it=mt.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(it=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(it=i.R11F_G11F_B10F)),w===i.RGBA){let st=ht?Br:re.getTransfer(nt);$===i.FLOAT&&(it=i.RGBA32F),$===i.HALF_FLOAT&&(it=i.RGBA16F),$===i.UNSIGNED_BYTE&&(it=st===me?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&mt&&(it=mt.RGBA16_EXT),$===i.SHORT&&mt&&(it=mt.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(it=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(it=i.RGB5_A1)}return(it===i.R16F||it===i.R32F||it===i.RG16F||it===i.RG32F||it===i.RGBA16F||it===i.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function _(P,w){let $;return P?w===null||w===Gn||w===ps?$=i.DEPTH24_STENCIL8:w===mn?$=i.DEPTH32F_STENCIL8:w===rr&&($=i.DEPTH24_STENCIL8,Gt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Gn||w===ps?$=i.DEPTH_COMPONENT24:w===mn?$=i.DEPTH_COMPONENT32F:w===rr&&($=i.DEPTH_COMPONENT16),$}function y(P,w){return b(P)===!0||P.isFramebufferTexture&&P.minFilter!==Xe&&P.minFilter!==ln?Math.log2(Math.max(w.width,w.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?w.mipmaps.length:1}function R(P){let w=new WeakRef(P);n.get(P).__ref=w,m.add(w),v.register(P,w,w)}function A(P){let w=n.get(P).__ref;w!==void 0&&(m.delete(w),v.unregister(w))}function C(P){O(P.target)}function N(P){I(P.target)}function O(P){P.removeEventListener("dispose",C),A(P),D(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&d.delete(P)}function I(P){P.removeEventListener("dispose",N),A(P),B(P)}function k(){for(let P of m){let w=P.deref();w!==void 0&&(w.isRenderTarget===!0?I(w):O(w))}m.clear(),d.clear()}function D(P){let w=n.get(P);if(w.__webglInit===void 0)return;let $=P.source,lt=f.get($);if(lt){let nt=lt[w.__cacheKey];nt.usedTimes--,nt.usedTimes===0&&L(P),Object.keys(lt).length===0&&f.delete($)}n.remove(P)}function L(P){let w=n.get(P);i.deleteTexture(w.__webglTexture);let $=P.source,lt=f.get($);delete lt[w.__cacheKey],o.memory.textures--}function B(P){let w=n.get(P);w.__depthDisposeCallback&&w.__depthDisposeCallback();let $=P.depthTexture;if($&&$.renderTarget===P&&O($),P.isWebGLCubeRenderTarget)for(let nt=0;nt<6;nt++){if(Array.isArray(w.__webglFramebuffer[nt]))for(let ht=0;ht<w.__webglFramebuffer[nt].length;ht++)i.deleteFramebuffer(w.__webglFramebuffer[nt][ht]);else i.deleteFramebuffer(w.__webglFramebuffer[nt]);w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer[nt])}else{if(Array.isArray(w.__webglFramebuffer))for(let nt=0;nt<w.__webglFramebuffer.length;nt++)i.deleteFramebuffer(w.__webglFramebuffer[nt]);else i.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&i.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&i.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let nt=0;nt<w.__webglColorRenderbuffer.length;nt++)w.__webglColorRenderbuffer[nt]&&i.deleteRenderbuffer(w.__webglColorRenderbuffer[nt]);w.__webglDepthRenderbuffer&&i.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let lt=P.textures;for(let nt=0,ht=lt.length;nt<ht;nt++){let mt=n.get(lt[nt]);mt.__webglTexture&&(i.deleteTexture(mt.__webglTexture),o.memory.textures--),n.remove(lt[nt])}n.remove(P)}let z=0;function F(){z=0}function X(){return z}function et(P){z=P}function W(){let P=z;return P>=s.maxTextures&&Gt("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),z+=1,P}function U(P){let w=[];return w.push(P.wrapS),w.push(P.wrapT),w.push(P.wrapR||0),w.push(P.magFilter),w.push(P.minFilter),w.push(P.anisotropy),w.push(P.internalFormat),w.push(P.format),w.push(P.type),w.push(P.generateMipmaps),w.push(P.mipmapsAutoUpdate),w.push(P.premultiplyAlpha),w.push(P.flipY),w.push(P.unpackAlignment),w.push(P.colorSpace),w.join()}function Q(P,w){let $=n.get(P);if(P.isVideoTexture&&Bt(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&$.__version!==P.version){let lt=P.image;if(lt===null)Gt("WebGLRenderer: Texture marked for update but no image data found.");else if(lt.complete===!1)Gt("WebGLRenderer: Texture marked for update but image is incomplete");else{Tt($,P,w);return}}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,$.__webglTexture,i.TEXTURE0+w)}function K(P,w){let $=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){Tt($,P,w);return}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+w)}function at(P,w){let $=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){Tt($,P,w);return}e.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+w)}function ot(P,w){let $=n.get(P);if(P.version>0&&$.__version!==P.version){dt($,P,w);return}e.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+w)}let It={[Vs]:i.REPEAT,[Yn]:i.CLAMP_TO_EDGE,[Ta]:i.MIRRORED_REPEAT},Xt={[Xe]:i.NEAREST,[yf]:i.NEAREST_MIPMAP_NEAREST,[xo]:i.NEAREST_MIPMAP_LINEAR,[ln]:i.LINEAR,[nl]:i.LINEAR_MIPMAP_NEAREST,[_i]:i.LINEAR_MIPMAP_LINEAR},Ct={[bf]:i.NEVER,[Uh]:i.ALWAYS,[wf]:i.LESS,[Dh]:i.LEQUAL,[Ef]:i.EQUAL,[Nh]:i.GEQUAL,[Af]:i.GREATER,[Tf]:i.NOTEQUAL};function Kt(P,w){if(w.type===mn&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===ln||w.magFilter===nl||w.magFilter===xo||w.magFilter===_i||w.minFilter===ln||w.minFilter===nl||w.minFilter===xo||w.minFilter===_i)&&Gt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,It[w.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,It[w.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,It[w.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,Xt[w.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,Xt[w.minFilter]),w.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,Ct[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Xe||w.minFilter!==xo&&w.minFilter!==_i||w.type===mn&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||n.get(w).__currentAnisotropy){let $=t.get("EXT_texture_filter_anisotropic");i.texParameterf(P,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),n.get(w).__currentAnisotropy=w.anisotropy}}}function Jt(P,w){let $=!1;P.__webglInit===void 0&&(P.__webglInit=!0,w.addEventListener("dispose",C),R(w));let lt=w.source,nt=f.get(lt);nt===void 0&&(nt={},f.set(lt,nt));let ht=U(w);if(ht!==P.__cacheKey){nt[ht]===void 0&&(nt[ht]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,$=!0),nt[ht].usedTimes++;let mt=nt[P.__cacheKey];mt!==void 0&&(nt[P.__cacheKey].usedTimes--,mt.usedTimes===0&&L(w)),P.__cacheKey=ht,P.__webglTexture=nt[ht].texture}return $}function Ht(P,w,$){return Math.floor(Math.floor(P/$)/w)}function Mt(P,w,$,lt){let ht=P.updateRanges;if(ht.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,w.width,w.height,$,lt,w.data);else{ht.sort((G,rt)=>G.start-rt.start);let mt=0;for(let G=1;G<ht.length;G++){let rt=ht[mt],tt=ht[G],_t=rt.start+rt.count,ft=Ht(tt.start,w.width,4),pt=Ht(rt.start,w.width,4);tt.start<=_t+1&&ft===pt&&Ht(tt.start+tt.count-1,w.width,4)===ft?rt.count=Math.max(rt.count,tt.start+tt.count-rt.start):(++mt,ht[mt]=tt)}ht.length=mt+1;let it=e.getParameter(i.UNPACK_ROW_LENGTH),st=e.getParameter(i.UNPACK_SKIP_PIXELS),gt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,w.width);for(let G=0,rt=ht.length;G<rt;G++){let tt=ht[G],_t=Math.floor(tt.start/4),ft=Math.ceil(tt.count/4),pt=_t%w.width,kt=Math.floor(_t/w.width),te=ft,ut=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,pt),e.pixelStorei(i.UNPACK_SKIP_ROWS,kt),e.texSubImage2D(i.TEXTURE_2D,0,pt,kt,te,ut,$,lt,w.data)}P.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,it),e.pixelStorei(i.UNPACK_SKIP_PIXELS,st),e.pixelStorei(i.UNPACK_SKIP_ROWS,gt)}}function Tt(P,w,$){let lt=i.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(lt=i.TEXTURE_2D_ARRAY),w.isData3DTexture&&(lt=i.TEXTURE_3D);let nt=Jt(P,w),ht=w.source;e.bindTexture(lt,P.__webglTexture,i.TEXTURE0+$);let mt=n.get(ht);if(ht.version!==mt.__version||nt===!0){if(e.activeTexture(i.TEXTURE0+$),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ut=re.getPrimaries(re.workingColorSpace),zt=w.colorSpace===yi?null:re.getPrimaries(w.colorSpace),jt=w.colorSpace===yi||ut===zt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,jt)}e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment);let st=x(w.image,!1,s.maxTextureSize);st=yt(w,st);let gt=r.convert(w.format,w.colorSpace),G=r.convert(w.type),rt=S(w.internalFormat,gt,G,w.normalized,w.colorSpace,w.isVideoTexture);Kt(lt,w);let tt,_t=w.mipmaps,ft=w.isVideoTexture!==!0,pt=mt.__version===void 0||nt===!0,kt=ht.dataReady,te=y(w,st);if(w.isDepthTexture)rt=_(w.format===xi,w.type),pt&&(ft?e.texStorage2D(i.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,gt,G,null));else if(w.isDataTexture)if(_t.length>0){ft&&pt&&e.texStorage2D(i.TEXTURE_2D,te,rt,_t[0].width,_t[0].height);for(let ut=0,zt=_t.length;ut<zt;ut++)tt=_t[ut],ft?kt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,tt.width,tt.height,gt,G,tt.data):e.texImage2D(i.TEXTURE_2D,ut,rt,tt.width,tt.height,0,gt,G,tt.data);w.generateMipmaps=!1}else ft?(pt&&e.texStorage2D(i.TEXTURE_2D,te,rt,st.width,st.height),kt&&Mt(w,st,gt,G)):e.texImage2D(i.TEXTURE_2D,0,rt,st.width,st.height,0,gt,G,st.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){ft&&pt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,te,rt,_t[0].width,_t[0].height,st.depth);for(let ut=0,zt=_t.length;ut<zt;ut++)if(tt=_t[ut],w.format!==An)if(gt!==null)if(ft){if(kt)if(w.layerUpdates.size>0){let jt=qh(tt.width,tt.height,w.format,w.type);for(let wt of w.layerUpdates){let xe=tt.data.subarray(wt*jt/tt.data.BYTES_PER_ELEMENT,(wt+1)*jt/tt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,wt,tt.width,tt.height,1,gt,xe)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,tt.width,tt.height,st.depth,gt,tt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ut,rt,tt.width,tt.height,st.depth,0,tt.data,0,0);else Gt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ft?kt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ut,0,0,0,tt.width,tt.height,st.depth,gt,G,tt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ut,rt,tt.width,tt.height,st.depth,0,gt,G,tt.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{ft&&pt&&e.texStorage2D(i.TEXTURE_2D,te,rt,_t[0].width,_t[0].height);for(let ut=0,zt=_t.length;ut<zt;ut++)tt=_t[ut],w.format!==An?gt!==null?ft?kt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ut,0,0,tt.width,tt.height,gt,tt.data):e.compressedTexImage2D(i.TEXTURE_2D,ut,rt,tt.width,tt.height,0,tt.data):Gt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ft?kt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,tt.width,tt.height,gt,G,tt.data):e.texImage2D(i.TEXTURE_2D,ut,rt,tt.width,tt.height,0,gt,G,tt.data)}else if(w.isDataArrayTexture)if(ft){if(pt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,te,rt,st.width,st.height,st.depth),kt)if(w.layerUpdates.size>0){let ut=qh(st.width,st.height,w.format,w.type);for(let zt of w.layerUpdates){let jt=st.data.subarray(zt*ut/st.data.BYTES_PER_ELEMENT,(zt+1)*ut/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,zt,st.width,st.height,1,gt,G,jt)}w.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,gt,G,st.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,gt,G,st.data);else if(w.isData3DTexture)ft?(pt&&e.texStorage3D(i.TEXTURE_3D,te,rt,st.width,st.height,st.depth),kt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,gt,G,st.data)):e.texImage3D(i.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,gt,G,st.data);else if(w.isFramebufferTexture){if(pt)if(ft)e.texStorage2D(i.TEXTURE_2D,te,rt,st.width,st.height);else{let ut=st.width,zt=st.height;for(let jt=0;jt<te;jt++)e.texImage2D(i.TEXTURE_2D,jt,rt,ut,zt,0,gt,G,null),ut>>=1,zt>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in i){let ut=i.canvas;if(ut.hasAttribute("layoutsubtree")||ut.setAttribute("layoutsubtree","true"),st.parentNode!==ut){ut.appendChild(st),d.add(w),ut.onpaint=zt=>{let jt=zt.changedElements;for(let wt of d)jt.includes(wt.image)&&(wt.needsUpdate=!0)},ut.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,st);else{let jt=i.RGBA,wt=i.RGBA,xe=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,jt,wt,xe,st)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(_t.length>0){if(ft&&pt){let ut=Pt(_t[0]);e.texStorage2D(i.TEXTURE_2D,te,rt,ut.width,ut.height)}for(let ut=0,zt=_t.length;ut<zt;ut++)tt=_t[ut],ft?kt&&e.texSubImage2D(i.TEXTURE_2D,ut,0,0,gt,G,tt):e.texImage2D(i.TEXTURE_2D,ut,rt,gt,G,tt);w.generateMipmaps=!1}else if(ft){if(pt){let ut=Pt(st);e.texStorage2D(i.TEXTURE_2D,te,rt,ut.width,ut.height)}kt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,gt,G,st)}else e.texImage2D(i.TEXTURE_2D,0,rt,gt,G,st);b(w)&&w.mipmapsAutoUpdate===!0&&M(lt),mt.__version=ht.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function dt(P,w,$){if(w.image.length!==6)return;let lt=Jt(P,w),nt=w.source;e.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+$);let ht=n.get(nt);if(nt.version!==ht.__version||lt===!0){e.activeTexture(i.TEXTURE0+$);let mt=re.getPrimaries(re.workingColorSpace),it=w.colorSpace===yi?null:re.getPrimaries(w.colorSpace),st=w.colorSpace===yi||mt===it?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let gt=w.isCompressedTexture||w.image[0].isCompressedTexture,G=w.image[0]&&w.image[0].isDataTexture,rt=[];for(let wt=0;wt<6;wt++)!gt&&!G?rt[wt]=x(w.image[wt],!0,s.maxCubemapSize):rt[wt]=G?w.image[wt].image:w.image[wt],rt[wt]=yt(w,rt[wt]);let tt=rt[0],_t=r.convert(w.format,w.colorSpace),ft=r.convert(w.type),pt=S(w.internalFormat,_t,ft,w.normalized,w.colorSpace),kt=w.isVideoTexture!==!0,te=ht.__version===void 0||lt===!0,ut=nt.dataReady,zt=y(w,tt);Kt(i.TEXTURE_CUBE_MAP,w);let jt;if(w.isDepthTexture){if(pt=_(w.format===xi,w.type),te)if(kt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,pt,tt.width,tt.height);else for(let wt=0;wt<6;wt++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,0,pt,tt.width,tt.height,0,_t,ft,null)}else if(gt){kt&&te&&e.texStorage2D(i.TEXTURE_CUBE_MAP,zt,pt,tt.width,tt.height);for(let wt=0;wt<6;wt++){jt=rt[wt].mipmaps;for(let xe=0;xe<jt.length;xe++){let ze=jt[xe];w.format!==An?_t!==null?kt?ut&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,xe,0,0,ze.width,ze.height,_t,ze.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,xe,pt,ze.width,ze.height,0,ze.data):Gt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,xe,0,0,ze.width,ze.height,_t,ft,ze.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,xe,pt,ze.width,ze.height,0,_t,ft,ze.data)}}}else{if(jt=w.mipmaps,kt&&te){jt.length>0&&zt++;let wt=Pt(rt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,zt,pt,wt.width,wt.height)}for(let wt=0;wt<6;wt++)if(G){kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,0,0,0,rt[wt].width,rt[wt].height,_t,ft,rt[wt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,0,pt,rt[wt].width,rt[wt].height,0,_t,ft,rt[wt].data);for(let xe=0;xe<jt.length;xe++){let wi=jt[xe].image[wt].image;kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,xe+1,0,0,wi.width,wi.height,_t,ft,wi.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,xe+1,pt,wi.width,wi.height,0,_t,ft,wi.data)}}else{kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,0,0,0,_t,ft,rt[wt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,0,pt,_t,ft,rt[wt]);for(let xe=0;xe<jt.length;xe++){let ze=jt[xe];kt?ut&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,xe+1,0,0,_t,ft,ze.image[wt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+wt,xe+1,pt,_t,ft,ze.image[wt])}}}b(w)&&w.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),ht.__version=nt.version,w.onUpdate&&w.onUpdate(w)}P.__version=w.version}function Rt(P,w,$,lt,nt,ht){let mt=r.convert($.format,$.colorSpace),it=r.convert($.type),st=S($.internalFormat,mt,it,$.normalized,$.colorSpace),gt=n.get(w),G=n.get($);if(G.__renderTarget=w,!gt.__hasExternalTextures){let rt=Math.max(1,w.width>>ht),tt=Math.max(1,w.height>>ht);nt===i.TEXTURE_3D||nt===i.TEXTURE_2D_ARRAY?e.texImage3D(nt,ht,st,rt,tt,w.depth,0,mt,it,null):e.texImage2D(nt,ht,st,rt,tt,0,mt,it,null)}e.bindFramebuffer(i.FRAMEBUFFER,P),Z(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,lt,nt,G.__webglTexture,0,pe(w)):(nt===i.TEXTURE_2D||nt>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&nt<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,lt,nt,G.__webglTexture,ht),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Vt(P,w,$){if(i.bindRenderbuffer(i.RENDERBUFFER,P),w.depthBuffer){let lt=w.depthTexture,nt=lt&&lt.isDepthTexture?lt.type:null,ht=_(w.stencilBuffer,nt),mt=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Z(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,pe(w),ht,w.width,w.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,pe(w),ht,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,ht,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,mt,i.RENDERBUFFER,P)}else{let lt=w.textures;for(let nt=0;nt<lt.length;nt++){let ht=lt[nt],mt=r.convert(ht.format,ht.colorSpace),it=r.convert(ht.type),st=S(ht.internalFormat,mt,it,ht.normalized,ht.colorSpace);Z(w)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,pe(w),st,w.width,w.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,pe(w),st,w.width,w.height):i.renderbufferStorage(i.RENDERBUFFER,st,w.width,w.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function ct(P,w,$){let lt=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,P),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let nt=n.get(w.depthTexture);nt.__renderTarget=w;let ht=lt?w.depthTexture.image[0]:w.depthTexture.image;(!nt.__webglTexture||ht.width!==w.width||ht.height!==w.height)&&(ht.width=w.width,ht.height=w.height,w.depthTexture.needsUpdate=!0),lt?ot(w.depthTexture,0):Q(w.depthTexture,0);let mt=nt.__webglTexture,it=pe(w),st=lt?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,gt=w.depthTexture.format===xi?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(w.depthTexture.format===fi)Z(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,gt,st,mt,0,it):i.framebufferTexture2D(i.FRAMEBUFFER,gt,st,mt,0);else if(w.depthTexture.format===xi)Z(w)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,gt,st,mt,0,it):i.framebufferTexture2D(i.FRAMEBUFFER,gt,st,mt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Lt(P){let w=n.get(P),$=P.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==P.depthTexture){let lt=P.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),lt){let nt=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,lt.removeEventListener("dispose",nt)};lt.addEventListener("dispose",nt),w.__depthDisposeCallback=nt}w.__boundDepthTexture=lt}if(P.depthTexture&&!w.__autoAllocateDepthBuffer)if($)for(let lt=0;lt<6;lt++)ct(w.__webglFramebuffer[lt],P,lt);else P.texture.mipmaps.length>0?ct(w.__webglFramebuffer[0],P,0):ct(w.__webglFramebuffer,P,0);else if($){w.__webglDepthbuffer=[];for(let lt=0;lt<6;lt++)if(e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[lt]),w.__webglDepthbuffer[lt]===void 0)w.__webglDepthbuffer[lt]=i.createRenderbuffer(),Vt(w.__webglDepthbuffer[lt],P,!1);else{let nt=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ht=w.__webglDepthbuffer[lt];i.bindRenderbuffer(i.RENDERBUFFER,ht),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.RENDERBUFFER,ht)}}else if(P.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=i.createRenderbuffer(),Vt(w.__webglDepthbuffer,P,!1);else{let nt=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ht=w.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ht),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.RENDERBUFFER,ht)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Ft(P,w,$){let lt=n.get(P);w!==void 0&&Rt(lt.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&Lt(P)}function Qt(P){let w=P.texture,$=n.get(P),lt=n.get(w);P.addEventListener("dispose",N),R(P);let nt=P.textures,ht=P.isWebGLCubeRenderTarget===!0,mt=nt.length>1;if(mt||(lt.__webglTexture===void 0&&(lt.__webglTexture=i.createTexture()),lt.__version=w.version,o.memory.textures++),ht){$.__webglFramebuffer=[];for(let it=0;it<6;it++)if(w.mipmaps.length>0){$.__webglFramebuffer[it]=[];for(let st=0;st<w.mipmaps.length;st++)$.__webglFramebuffer[it][st]=i.createFramebuffer()}else $.__webglFramebuffer[it]=i.createFramebuffer()}else{if(w.mipmaps.length>0){$.__webglFramebuffer=[];for(let it=0;it<w.mipmaps.length;it++)$.__webglFramebuffer[it]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(mt)for(let it=0,st=nt.length;it<st;it++){let gt=n.get(nt[it]);gt.__webglTexture===void 0&&(gt.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&Z(P)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),$.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let it=0;it<nt.length;it++){let st=nt[it];$.__webglColorRenderbuffer[it]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[it]);let gt=r.convert(st.format,st.colorSpace),G=r.convert(st.type),rt=S(st.internalFormat,gt,G,st.normalized,st.colorSpace,P.isXRRenderTarget===!0),tt=pe(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,tt,rt,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+it,i.RENDERBUFFER,$.__webglColorRenderbuffer[it])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&($.__webglDepthRenderbuffer=i.createRenderbuffer(),Vt($.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ht){e.bindTexture(i.TEXTURE_CUBE_MAP,lt.__webglTexture),Kt(i.TEXTURE_CUBE_MAP,w);for(let it=0;it<6;it++)if(w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Rt($.__webglFramebuffer[it][st],P,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+it,st);else Rt($.__webglFramebuffer[it],P,w,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+it,0);b(w)?M(i.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(mt){for(let it=0,st=nt.length;it<st;it++){let gt=nt[it],G=n.get(gt),rt=i.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(rt=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(rt,G.__webglTexture),Kt(rt,gt),Rt($.__webglFramebuffer,P,gt,i.COLOR_ATTACHMENT0+it,rt,0),b(gt)&&M(rt)}e.unbindTexture()}else{let it=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(it=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(it,lt.__webglTexture),Kt(it,w),w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)Rt($.__webglFramebuffer[st],P,w,i.COLOR_ATTACHMENT0,it,st);else Rt($.__webglFramebuffer,P,w,i.COLOR_ATTACHMENT0,it,0);b(w)?M(it):w.mipmaps.length>0&&i.texParameteri(it,i.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}P.depthBuffer&&Lt(P)}function H(P){let w=P.textures;for(let $=0,lt=w.length;$<lt;$++){let nt=w[$];if(b(nt)&&nt.mipmapsAutoUpdate===!0){let ht=E(P),mt=n.get(nt).__webglTexture;e.bindTexture(ht,mt),M(ht),e.unbindTexture()}}}let _e=[];function ce(P){if(P.samples>0){if(Z(P)===!1){let w=P.textures,$=P.width,lt=P.height,nt=i.COLOR_BUFFER_BIT,ht=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,mt=n.get(P),it=w.length>1;if(it)for(let gt=0;gt<w.length;gt++)e.bindFramebuffer(i.FRAMEBUFFER,mt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,mt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,mt.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,mt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,mt.__webglFramebuffer);for(let gt=0;gt<w.length;gt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(nt|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(nt|=i.STENCIL_BUFFER_BIT)),it){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,mt.__webglColorRenderbuffer[gt]);let G=n.get(w[gt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,G,0)}i.blitFramebuffer(0,0,$,lt,0,0,$,lt,nt,i.NEAREST),l===!0&&(_e.length=0,_e.push(i.COLOR_ATTACHMENT0+gt),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&_e.push(ht),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,_e))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),it)for(let gt=0;gt<w.length;gt++){e.bindFramebuffer(i.FRAMEBUFFER,mt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.RENDERBUFFER,mt.__webglColorRenderbuffer[gt]);let G=n.get(w[gt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,mt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+gt,i.TEXTURE_2D,G,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,mt.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let w=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[w])}}}function pe(P){return Math.min(s.maxSamples,P.samples)}function Z(P){let w=n.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Bt(P){let w=o.render.frame;h.get(P)!==w&&(h.set(P,w),P.update())}function yt(P,w){let $=P.colorSpace,lt=P.format,nt=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||$!==os&&$!==yi&&(re.getTransfer($)===me?(lt!==An||nt!==pn)&&Gt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Wt("WebGLTextures: Unsupported texture color space:",$)),w}function Pt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=W,this.resetTextureUnits=F,this.getTextureUnits=X,this.setTextureUnits=et,this.setTexture2D=Q,this.setTexture2DArray=K,this.setTexture3D=at,this.setTextureCube=ot,this.rebindTextures=Ft,this.setupRenderTarget=Qt,this.updateRenderTargetMipmap=H,this.updateMultisampleRenderTarget=ce,this.setupDepthRenderbuffer=Lt,this.setupFrameBufferTexture=Rt,this.useMultisampledRTT=Z,this.dispose=k}function tM(i,t){function e(n,s=yi){let r,o=re.getTransfer(s);if(n===pn)return i.UNSIGNED_BYTE;if(n===sl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===rl)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Ch)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Ph)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Th)return i.BYTE;if(n===Rh)return i.SHORT;if(n===rr)return i.UNSIGNED_SHORT;if(n===il)return i.INT;if(n===Gn)return i.UNSIGNED_INT;if(n===mn)return i.FLOAT;if(n===Hn)return i.HALF_FLOAT;if(n===Ih)return i.ALPHA;if(n===Lh)return i.RGB;if(n===An)return i.RGBA;if(n===fi)return i.DEPTH_COMPONENT;if(n===xi)return i.DEPTH_STENCIL;if(n===ol)return i.RED;if(n===al)return i.RED_INTEGER;if(n===Hi)return i.RG;if(n===ll)return i.RG_INTEGER;if(n===cl)return i.RGBA_INTEGER;if(n===yo||n===vo||n===Mo||n===So)if(o===me)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===yo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===vo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Mo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===So)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===yo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===vo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Mo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===So)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===hl||n===ul||n===dl||n===fl)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===hl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ul)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===dl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===fl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===pl||n===ml||n===gl||n===_l||n===xl||n===bo||n===yl)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===pl||n===ml)return o===me?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===gl)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===_l)return r.COMPRESSED_R11_EAC;if(n===xl)return r.COMPRESSED_SIGNED_R11_EAC;if(n===bo)return r.COMPRESSED_RG11_EAC;if(n===yl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===vl||n===Ml||n===Sl||n===bl||n===wl||n===El||n===Al||n===Tl||n===Rl||n===Cl||n===Pl||n===Il||n===Ll||n===Dl)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===vl)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Ml)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Sl)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===bl)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===wl)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===El)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Al)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Tl)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Rl)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Cl)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Pl)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Il)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Ll)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Dl)return o===me?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Nl||n===Ul||n===Ol)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Nl)return o===me?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Ul)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Ol)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Fl||n===Bl||n===wo||n===kl)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Fl)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Bl)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===wo)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===kl)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===ps?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var eM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,nM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,eu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new Jr(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new In({vertexShader:eM,fragmentShader:nM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new we(new Oi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},nu=class extends zn{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,m=null,v=typeof XRWebGLBinding<"u",p=new eu,g={},x=e.getContextAttributes(),b=null,M=null,E=[],S=[],_=new bt,y=null,R=null,A=new an;A.viewport=new be;let C=new an;C.viewport=new be;let N=[A,C],O=new Qa,I=null,k=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(U){let Q=E[U];return Q===void 0&&(Q=new Ys,E[U]=Q),Q.getTargetRaySpace()},this.getControllerGrip=function(U){let Q=E[U];return Q===void 0&&(Q=new Ys,E[U]=Q),Q.getGripSpace()},this.getHand=function(U){let Q=E[U];return Q===void 0&&(Q=new Ys,E[U]=Q),Q.getHandSpace()};function D(U){let Q=S.indexOf(U.inputSource);if(Q===-1)return;let K=E[Q];K!==void 0&&(K.update(U.inputSource,U.frame,c||o),K.dispatchEvent({type:U.type,data:U.inputSource}))}function L(){s.removeEventListener("select",D),s.removeEventListener("selectstart",D),s.removeEventListener("selectend",D),s.removeEventListener("squeeze",D),s.removeEventListener("squeezestart",D),s.removeEventListener("squeezeend",D),s.removeEventListener("end",L),s.removeEventListener("inputsourceschange",B);for(let U=0;U<E.length;U++){let Q=S[U];Q!==null&&(S[U]=null,E[U].disconnect(Q))}I=null,k=null,p.reset();for(let U in g)delete g[U];if(t.setRenderTarget(b),f=null,u=null,d=null,s=null,M=null,W.stop(),n.isPresenting=!1,t.setPixelRatio(y),t.setSize(_.width,_.height,!1),R!==null){let U=R.camera;U.fov=R.fov,U.zoom=R.zoom,U.updateProjectionMatrix(),R=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(U){r=U,n.isPresenting===!0&&Gt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(U){a=U,n.isPresenting===!0&&Gt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(U){c=U},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(U){if(s=U,s!==null){if(b=t.getRenderTarget(),s.addEventListener("select",D),s.addEventListener("selectstart",D),s.addEventListener("selectend",D),s.addEventListener("squeeze",D),s.addEventListener("squeezestart",D),s.addEventListener("squeezeend",D),s.addEventListener("end",L),s.addEventListener("inputsourceschange",B),x.xrCompatible!==!0&&await e.makeXRCompatible(),y=t.getPixelRatio(),t.getSize(_),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let K=null,at=null,ot=null;x.depth&&(ot=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,K=x.stencil?xi:fi,at=x.stencil?ps:Gn);let It={colorFormat:e.RGBA8,depthFormat:ot,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(It),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),M=new bn(u.textureWidth,u.textureHeight,{format:An,type:pn,depthTexture:new gi(u.textureWidth,u.textureHeight,at,void 0,void 0,void 0,void 0,void 0,void 0,K),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let K={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,K),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new bn(f.framebufferWidth,f.framebufferHeight,{format:An,type:pn,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),W.setContext(s),W.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function B(U){for(let Q=0;Q<U.removed.length;Q++){let K=U.removed[Q],at=S.indexOf(K);at>=0&&(S[at]=null,E[at].disconnect(K))}for(let Q=0;Q<U.added.length;Q++){let K=U.added[Q],at=S.indexOf(K);if(at===-1){for(let It=0;It<E.length;It++)if(It>=S.length){S.push(K),at=It;break}else if(S[It]===null){S[It]=K,at=It;break}if(at===-1)break}let ot=E[at];ot&&ot.connect(K)}}function z(U,Q){Q===null?U.matrixWorld.copy(U.matrix):U.matrixWorld.multiplyMatrices(Q.matrixWorld,U.matrix),U.matrixWorldInverse.copy(U.matrixWorld).invert()}this.updateCamera=function(U){if(s===null)return;let Q=U.near,K=U.far;p.texture!==null&&(p.depthNear>0&&(Q=p.depthNear),p.depthFar>0&&(K=p.depthFar)),O.near=C.near=A.near=Q,O.far=C.far=A.far=K,(I!==O.near||k!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),I=O.near,k=O.far),O.layers.mask=U.layers.mask|6,A.layers.mask=O.layers.mask&-5,C.layers.mask=O.layers.mask&-3;let at=U.parent,ot=O.cameras;z(O,at);for(let It=0;It<ot.length;It++)z(ot[It],at);O.projectionMatrix.copy(A.projectionMatrix),O.projectionMatrixInverse.copy(A.projectionMatrixInverse),R===null&&U.isPerspectiveCamera&&(R={camera:U,fov:U.fov,zoom:U.zoom}),F(U,O,at)};function F(U,Q,K){K===null?U.matrix.copy(Q.matrixWorld):(U.matrix.copy(K.matrixWorld),U.matrix.invert(),U.matrix.multiply(Q.matrixWorld)),U.matrix.decompose(U.position,U.quaternion,U.scale),U.updateMatrixWorld(!0),U.projectionMatrix.copy(Q.projectionMatrix),U.projectionMatrixInverse.copy(Q.projectionMatrixInverse),U.isPerspectiveCamera&&(U.fov=qs*2*Math.atan(1/U.projectionMatrix.elements[5]),U.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(U){l=U,u!==null&&(u.fixedFoveation=U),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=U)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(O)},this.getCameraTexture=function(U){return g[U]};let X=null;function et(U,Q){if(h=Q.getViewerPose(c||o),m=Q,h!==null){let K=h.views;f!==null&&(t.setRenderTargetFramebuffer(M,f.framebuffer),t.setRenderTarget(M));let at=!1;K.length!==O.cameras.length&&(O.cameras.length=0,at=!0);for(let Ct=0;Ct<K.length;Ct++){let Kt=K[Ct],Jt=null;if(f!==null)Jt=f.getViewport(Kt);else{let Mt=d.getViewSubImage(u,Kt);Jt=Mt.viewport,Ct===0&&(t.setRenderTargetTextures(M,Mt.colorTexture,Mt.depthStencilTexture),t.setRenderTarget(M))}let Ht=N[Ct];Ht===void 0&&(Ht=new an,Ht.layers.enable(Ct),Ht.viewport=new be,N[Ct]=Ht),Ht.matrix.fromArray(Kt.transform.matrix),Ht.matrix.decompose(Ht.position,Ht.quaternion,Ht.scale),Ht.projectionMatrix.fromArray(Kt.projectionMatrix),Ht.projectionMatrixInverse.copy(Ht.projectionMatrix).invert(),Ht.viewport.set(Jt.x,Jt.y,Jt.width,Jt.height),Ct===0&&(O.matrix.copy(Ht.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),at===!0&&O.cameras.push(Ht)}let ot=s.enabledFeatures;if(ot&&ot.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){d=n.getBinding();let Ct=d.getDepthInformation(K[0]);Ct&&Ct.isValid&&Ct.texture&&p.init(Ct,s.renderState)}if(ot&&ot.includes("camera-access")&&v){t.state.unbindTexture(),d=n.getBinding();for(let Ct=0;Ct<K.length;Ct++){let Kt=K[Ct].camera;if(Kt){let Jt=g[Kt];Jt||(Jt=new Jr,g[Kt]=Jt);let Ht=d.getCameraImage(Kt);Jt.sourceTexture=Ht}}}}for(let K=0;K<E.length;K++){let at=S[K],ot=E[K];at!==null&&ot!==void 0&&ot.update(at,Q,c||o)}X&&X(U,Q),Q.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:Q}),m=null}let W=new hp;W.setAnimationLoop(et),this.setAnimationLoop=function(U){X=U},this.dispose=function(){}}},iM=new ge,vp=new qt;vp.set(-1,0,0,0,1,0,0,0,1);function sM(i,t){function e(p,g){p.matrixAutoUpdate===!0&&p.updateMatrix(),g.value.copy(p.matrix)}function n(p,g){g.color.getRGB(p.fogColor.value,Vh(i)),g.isFog?(p.fogNear.value=g.near,p.fogFar.value=g.far):g.isFogExp2&&(p.fogDensity.value=g.density)}function s(p,g,x,b,M){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(p,g):g.isMeshLambertMaterial?(r(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(p,g),d(p,g)):g.isMeshPhongMaterial?(r(p,g),h(p,g),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(p,g),u(p,g),g.isMeshPhysicalMaterial&&f(p,g,M)):g.isMeshMatcapMaterial?(r(p,g),m(p,g)):g.isMeshDepthMaterial?r(p,g):g.isMeshDistanceMaterial?(r(p,g),v(p,g)):g.isMeshNormalMaterial?r(p,g):g.isLineBasicMaterial?(o(p,g),g.isLineDashedMaterial&&a(p,g)):g.isPointsMaterial?l(p,g,x,b):g.isSpriteMaterial?c(p,g):g.isShadowMaterial?(p.color.value.copy(g.color),p.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(p,g){p.opacity.value=g.opacity,g.color&&p.diffuse.value.copy(g.color),g.emissive&&p.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.bumpMap&&(p.bumpMap.value=g.bumpMap,e(g.bumpMap,p.bumpMapTransform),p.bumpScale.value=g.bumpScale,g.side===un&&(p.bumpScale.value*=-1)),g.normalMap&&(p.normalMap.value=g.normalMap,e(g.normalMap,p.normalMapTransform),p.normalScale.value.copy(g.normalScale),g.side===un&&p.normalScale.value.negate()),g.displacementMap&&(p.displacementMap.value=g.displacementMap,e(g.displacementMap,p.displacementMapTransform),p.displacementScale.value=g.displacementScale,p.displacementBias.value=g.displacementBias),g.emissiveMap&&(p.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,p.emissiveMapTransform)),g.specularMap&&(p.specularMap.value=g.specularMap,e(g.specularMap,p.specularMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest);let x=t.get(g),b=x.envMap,M=x.envMapRotation;b&&(p.envMap.value=b,p.envMapRotation.value.setFromMatrix4(iM.makeRotationFromEuler(M)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(vp),p.reflectivity.value=g.reflectivity,p.ior.value=g.ior,p.refractionRatio.value=g.refractionRatio),g.lightMap&&(p.lightMap.value=g.lightMap,p.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,p.lightMapTransform)),g.aoMap&&(p.aoMap.value=g.aoMap,p.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,p.aoMapTransform))}function o(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform))}function a(p,g){p.dashSize.value=g.dashSize,p.totalSize.value=g.dashSize+g.gapSize,p.scale.value=g.scale}function l(p,g,x,b){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.size.value=g.size*x,p.scale.value=b*.5,g.map&&(p.map.value=g.map,e(g.map,p.uvTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function c(p,g){p.diffuse.value.copy(g.color),p.opacity.value=g.opacity,p.rotation.value=g.rotation,g.map&&(p.map.value=g.map,e(g.map,p.mapTransform)),g.alphaMap&&(p.alphaMap.value=g.alphaMap,e(g.alphaMap,p.alphaMapTransform)),g.alphaTest>0&&(p.alphaTest.value=g.alphaTest)}function h(p,g){p.specular.value.copy(g.specular),p.shininess.value=Math.max(g.shininess,1e-4)}function d(p,g){g.gradientMap&&(p.gradientMap.value=g.gradientMap)}function u(p,g){p.metalness.value=g.metalness,g.metalnessMap&&(p.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,p.metalnessMapTransform)),p.roughness.value=g.roughness,g.roughnessMap&&(p.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,p.roughnessMapTransform)),g.envMap&&(p.envMapIntensity.value=g.envMapIntensity)}function f(p,g,x){p.ior.value=g.ior,g.diffuseRoughness>0&&(p.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),g.sheen>0&&(p.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),p.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(p.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,p.sheenColorMapTransform)),g.sheenRoughnessMap&&(p.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,p.sheenRoughnessMapTransform))),g.clearcoat>0&&(p.clearcoat.value=g.clearcoat,p.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(p.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,p.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(p.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===un&&p.clearcoatNormalScale.value.negate())),g.dispersion>0&&(p.dispersion.value=g.dispersion),g.retroreflectivity>0&&(p.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(p.iridescence.value=g.iridescence,p.iridescenceIOR.value=g.iridescenceIOR,p.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(p.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,p.iridescenceMapTransform)),g.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),g.transmission>0&&(p.transmission.value=g.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(p.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,p.transmissionMapTransform)),p.thickness.value=g.thickness,g.thicknessMap&&(p.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=g.attenuationDistance,p.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(p.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(p.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=g.specularIntensity,p.specularColor.value.copy(g.specularColor),g.specularColorMap&&(p.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,p.specularColorMapTransform)),g.specularIntensityMap&&(p.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,p.specularIntensityMapTransform))}function m(p,g){g.matcap&&(p.matcap.value=g.matcap)}function v(p,g){let x=t.get(g).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function rM(i,t,e,n){let s={},r={};function o(x,b){let M=b.program;n.uniformBlockBinding(x,M,s[x.id])}function a(x,b){let M=s[x.id];M===void 0&&(m(x),M=l(x),s[x.id]=M,x.addEventListener("dispose",p));let E=b.program;n.updateUBOMapping(x,E);let S=t.render.frame;r[x.id]!==S&&(c(x),r[x.id]=S)}function l(x){let b=i.createBuffer(),M=x.__size,E=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,b),i.bufferData(i.UNIFORM_BUFFER,M,E),i.bindBuffer(i.UNIFORM_BUFFER,null),b}function c(x){let b=s[x.id],M=x.uniforms,E=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,b);for(let S=0,_=M.length;S<_;S++){let y=M[S];if(Array.isArray(y))for(let R=0,A=y.length;R<A;R++)h(y[R],S,R,E);else h(y,S,0,E)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(x,b,M,E){if(u(x,b,M,E)===!0){let S=x.__offset,_=x.value;if(Array.isArray(_)){let y=0;for(let R=0;R<_.length;R++){let A=_[R],C=v(A,!0);d(A,x.__data,y),y+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else d(_,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,S,x.__data)}}function d(x,b,M){typeof x=="number"||typeof x=="boolean"?b[M]=x:x.isMatrix3?(b[M]=x.elements[0],b[M+1]=x.elements[1],b[M+2]=x.elements[2],b[M+3]=0,b[M+4]=x.elements[3],b[M+5]=x.elements[4],b[M+6]=x.elements[5],b[M+7]=0,b[M+8]=x.elements[6],b[M+9]=x.elements[7],b[M+10]=x.elements[8],b[M+11]=0):ArrayBuffer.isView(x)?b.set(x.subarray(0,b.length-M),M):x.toArray(b,M)}function u(x,b,M,E){let S=x.value,_=b+"_"+M;if(Array.isArray(S)){E[_]===void 0&&(E[_]=[]);let y=E[_],R=!1;for(let A=0;A<S.length;A++)f(S[A],y,A)===!0&&(R=!0);return R}return f(S,E,_)}function f(x,b,M){if(b[M]===void 0)return typeof x=="number"||typeof x=="boolean"?b[M]=x:ArrayBuffer.isView(x)?b[M]=x.slice():b[M]=x.clone(),!0;{let E=b[M];if(typeof x=="number"||typeof x=="boolean"){if(E!==x)return b[M]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(E.equals(x)===!1)return E.copy(x),!0}}return!1}function m(x){let b=x.uniforms,M=0,E=16;for(let _=0,y=b.length;_<y;_++){let R=Array.isArray(b[_])?b[_]:[b[_]];for(let A=0,C=R.length;A<C;A++){let N=R[A],O=Array.isArray(N.value)?N.value:[N.value],I=Array.isArray(b[_])||Array.isArray(N.value),k=M;for(let L=0,B=O.length;L<B;L++){let z=O[L],F=v(z,I),X=M%E,et=X%F.boundary,W=X+et;M+=et,W!==0&&E-W<F.storage&&(M+=E-W),L===0&&(k=M),M+=F.storage}let D=N.type==="int"?Int32Array:N.type==="uint"?Uint32Array:Float32Array;N.__data=new D((M-k)/Float32Array.BYTES_PER_ELEMENT),N.__offset=k}}let S=M%E;return S>0&&(M+=E-S),x.__size=M,x.__cache={},this}function v(x,b){let M={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(M.boundary=4,M.storage=4):x.isVector2?(M.boundary=8,M.storage=8):x.isVector3||x.isColor?(M.boundary=16,M.storage=12):x.isVector4?(M.boundary=16,M.storage=16):x.isMatrix3?(M.boundary=16,M.storage=48):x.isMatrix4?(M.boundary=16,M.storage=64):x.isTexture?Gt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(M.boundary=16,M.storage=x.byteLength):Gt("WebGLRenderer: Unsupported uniform value type.",x),b===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function p(x){let b=x.target;b.removeEventListener("dispose",p),i.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function g(){for(let x in s)i.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var oM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),jn=null;function aM(){return jn===null&&(jn=new as(oM,16,16,Hi,Hn),jn.name="DFG_LUT",jn.minFilter=ln,jn.magFilter=ln,jn.wrapS=Yn,jn.wrapT=Yn,jn.generateMipmaps=!1,jn.needsUpdate=!0),jn}var Wl=class{constructor(t={}){let{canvas:e=Cf(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=pn}=t;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let v=f,p=new Set([cl,ll,al]),g=new Set([pn,Gn,rr,ps,sl,rl]),x=new Uint32Array(4),b=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},E=null,S=null,_=[],y=[],R=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Kn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let A=this,C=!1,N=null,O=null,I=null,k=null;this._outputColorSpace=on;let D=0,L=0,B=null,z=-1,F=null,X=new be,et=new be,W=null,U=new Yt(0),Q=0,K=e.width,at=e.height,ot=1,It=null,Xt=null,Ct=new be(0,0,K,at),Kt=new be(0,0,K,at),Jt=!1,Ht=new Ui,Mt=new La,Tt=!1,dt=!1,Rt=new ge,Vt=new q,ct=new be,Lt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ft=!1;function Qt(){return B===null?ot:1}let H=n;function _e(T,V){return e.getContext(T,V)}let ce,pe,Z,Bt,yt,Pt,P,w,$,lt,nt,ht,mt,it,st,gt,G,rt,tt,_t,ft,pt,kt;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",zt,!1),e.addEventListener("webglcontextrestored",jt,!1),e.addEventListener("webglcontextcreationerror",wt,!1),H===null){let V="webgl2";if(H=_e(V,T),H===null)throw _e(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}te()}catch(T){throw e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",wt,!1),Wt("WebGLRenderer: "+T.message),T}function te(){ce=new xy(H),ce.init(),ft=new tM(H,ce),pe=new ay(H,ce,t,ft),Z=new jv(H,ce),pe.reversedDepthBuffer&&u&&Z.buffers.depth.setReversed(!0),O=H.createFramebuffer(),I=H.createFramebuffer(),k=H.createFramebuffer(),Bt=new My(H),yt=new Bv,Pt=new Qv(H,ce,Z,yt,pe,ft,Bt),P=new _y(A),w=new b0(H),pt=new ry(H,w),$=new yy(H,w,Bt,pt),lt=new by(H,$,w,pt,Bt),rt=new Sy(H,pe,Pt),st=new ly(yt),nt=new Fv(A,P,ce,pe,pt,st),ht=new sM(A,yt),mt=new zv,it=new qv(ce),G=new sy(A,P,Z,lt,m,l),gt=new Kv(A,lt,pe),kt=new rM(H,Bt,pe,Z),tt=new oy(H,ce,Bt),_t=new vy(H,ce,Bt),Bt.programs=nt.programs,A.capabilities=pe,A.extensions=ce,A.properties=yt,A.renderLists=mt,A.shadowMap=gt,A.state=Z,A.info=Bt}v!==pn&&(R=new Ey(v,e.width,e.height,a,s,r));let ut=new nu(A,H);this.xr=ut,this.getContext=function(){return H},this.getContextAttributes=function(){return H.getContextAttributes()},this.forceContextLoss=function(){let T=ce.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=ce.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return ot},this.setPixelRatio=function(T){T!==void 0&&(ot=T,this.setSize(K,at,!1))},this.getSize=function(T){return T.set(K,at)},this.setSize=function(T,V,j=!0){if(ut.isPresenting){Gt("WebGLRenderer: Can't change size while VR device is presenting.");return}K=T,at=V,e.width=Math.floor(T*ot),e.height=Math.floor(V*ot),j===!0&&(e.style.width=T+"px",e.style.height=V+"px"),R!==null&&R.setSize(e.width,e.height),this.setViewport(0,0,T,V)},this.getDrawingBufferSize=function(T){return T.set(K*ot,at*ot).floor()},this.setDrawingBufferSize=function(T,V,j){K=T,at=V,ot=j,e.width=Math.floor(T*j),e.height=Math.floor(V*j),this.setViewport(0,0,T,V)},this.setEffects=function(T){if(v===pn){Wt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let V=0;V<T.length;V++)if(T[V].isOutputPass===!0){Gt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}R.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(X)},this.getViewport=function(T){return T.copy(Ct)},this.setViewport=function(T,V,j,Y){T.isVector4?Ct.set(T.x,T.y,T.z,T.w):Ct.set(T,V,j,Y),Z.viewport(X.copy(Ct).multiplyScalar(Qt()).round())},this.getScissor=function(T){return T.copy(Kt)},this.setScissor=function(T,V,j,Y){T.isVector4?Kt.set(T.x,T.y,T.z,T.w):Kt.set(T,V,j,Y),Z.scissor(et.copy(Kt).multiplyScalar(Qt()).round())},this.getScissorTest=function(){return Jt},this.setScissorTest=function(T){Z.setScissorTest(Jt=T)},this.setOpaqueSort=function(T){It=T},this.setTransparentSort=function(T){Xt=T},this.getClearColor=function(T){return T.copy(G.getClearColor())},this.setClearColor=function(){G.setClearColor(...arguments)},this.getClearAlpha=function(){return G.getClearAlpha()},this.setClearAlpha=function(){G.setClearAlpha(...arguments)},this.clear=function(T=!0,V=!0,j=!0){let Y=0;if(T){let J=!1;if(B!==null){let vt=B.texture.format;J=p.has(vt)}if(J){let vt=B.texture.type,Dt=g.has(vt),xt=G.getClearColor(),At=G.getClearAlpha(),Ot=xt.r,Zt=xt.g,oe=xt.b;Dt?(x[0]=Ot,x[1]=Zt,x[2]=oe,x[3]=At,H.clearBufferuiv(H.COLOR,0,x)):(b[0]=Ot,b[1]=Zt,b[2]=oe,b[3]=At,H.clearBufferiv(H.COLOR,0,b))}else Y|=H.COLOR_BUFFER_BIT}V&&(Y|=H.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=H.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&H.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),N=T},this.dispose=function(){e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",wt,!1),G.dispose(),mt.dispose(),it.dispose(),Pt.dispose(),yt.dispose(),P.dispose(),lt.dispose(),$.dispose(),pt.dispose(),kt.dispose(),nt.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",Hu),ut.removeEventListener("sessionend",Vu),Yi.stop()};function zt(T){T.preventDefault(),Fh("WebGLRenderer: Context Lost."),C=!0}function jt(){Fh("WebGLRenderer: Context Restored."),C=!1;let T=Bt.autoReset,V=gt.enabled,j=gt.autoUpdate,Y=gt.needsUpdate,J=gt.type;te(),Bt.autoReset=T,gt.enabled=V,gt.autoUpdate=j,gt.needsUpdate=Y,gt.type=J}function wt(T){Wt("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function xe(T){let V=T.target;V.removeEventListener("dispose",xe),ze(V)}function ze(T){wi(T),yt.remove(T)}function wi(T){let V=yt.get(T).programs;V!==void 0&&(V.forEach(function(j){nt.releaseProgram(j)}),T.isShaderMaterial&&nt.releaseShaderCache(T))}this.renderBufferDirect=function(T,V,j,Y,J,vt){V===null&&(V=Lt);let Dt=J.isMesh&&J.matrixWorld.determinantAffine()<0,xt=Im(T,V,j,Y,J);Z.setMaterial(Y,Dt);let At=j.index,Ot=1;if(Y.wireframe===!0){if(At=$.getWireframeAttribute(j),At===void 0)return;Ot=2}let Zt=j.drawRange,oe=j.attributes.position,Nt=Zt.start*Ot,ae=(Zt.start+Zt.count)*Ot;vt!==null&&(Nt=Math.max(Nt,vt.start*Ot),ae=Math.min(ae,(vt.start+vt.count)*Ot)),At!==null?(Nt=Math.max(Nt,0),ae=Math.min(ae,At.count)):oe!=null&&(Nt=Math.max(Nt,0),ae=Math.min(ae,oe.count));let Ce=ae-Nt;if(Ce<0||Ce===1/0)return;pt.setup(J,Y,xt,j,At);let ve,ye=tt;if(At!==null&&(ve=w.get(At),ye=_t,ye.setIndex(ve)),J.isMesh)Y.wireframe===!0?(Z.setLineWidth(Y.wireframeLinewidth*Qt()),ye.setMode(H.LINES)):ye.setMode(H.TRIANGLES);else if(J.isLine){let Ze=Y.linewidth;Ze===void 0&&(Ze=1),Z.setLineWidth(Ze*Qt()),J.isLineSegments?ye.setMode(H.LINES):J.isLineLoop?ye.setMode(H.LINE_LOOP):ye.setMode(H.LINE_STRIP)}else J.isPoints?ye.setMode(H.POINTS):J.isSprite&&ye.setMode(H.TRIANGLES);if(J.isBatchedMesh)if(ce.get("WEBGL_multi_draw"))ye.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let Ze=J._multiDrawStarts,Ut=J._multiDrawCounts,sn=J._multiDrawCount,de=At?w.get(At).bytesPerElement:1,Zi=yt.get(Y).currentProgram.getUniforms();for(let Je=0;Je<sn;Je++)Zi.setValue(H,"_gl_DrawID",Je),ye.render(Ze[Je]/de,Ut[Je])}else if(J.isInstancedMesh)ye.renderInstances(Nt,Ce,J.count);else if(j.isInstancedBufferGeometry){let Ze=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ut=Math.min(j.instanceCount,Ze);ye.renderInstances(Nt,Ce,Ut)}else ye.render(Nt,Ce)};function Gu(T,V,j,Y){N!==null&&T.isNodeMaterial&&N.setObject(Y,T),Tt===!0&&st.setState(T,j,!1),T.transparent===!0&&T.side===Ie&&T.forceSinglePass===!1?(T.side=un,T.needsUpdate=!0,vr(T,V,Y),T.side=Jn,T.needsUpdate=!0,vr(T,V,Y),T.side=Ie):vr(T,V,Y)}this.compile=function(T,V,j=null){j===null&&(j=T),N!==null&&N.renderStart(T,V,j),S=it.get(j),S.init(V),y.push(S),j.traverseVisible(function(J){J.isLight&&J.layers.test(V.layers)&&(S.pushLight(J),J.castShadow&&S.pushShadow(J))}),T!==j&&T.traverseVisible(function(J){J.isLight&&J.layers.test(V.layers)&&(S.pushLight(J),J.castShadow&&S.pushShadow(J))}),S.setupLights(),N!==null&&N.updateLights(S.state.lightsArray),dt=this.localClippingEnabled,Tt=st.init(this.clippingPlanes,dt),Tt===!0&&st.setGlobalState(this.clippingPlanes,V),N!==null&&gt.render(S.state.shadowsArray,j,V);let Y=new Set;return T.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let vt=J.material;if(vt)if(Array.isArray(vt))for(let Dt=0;Dt<vt.length;Dt++){let xt=vt[Dt];Gu(xt,j,V,J),Y.add(xt)}else Gu(vt,j,V,J),Y.add(vt)}),S=y.pop(),N!==null&&N.renderEnd(),Y},this.compileAsync=function(T,V,j=null){let Y=this.compile(T,V,j);return new Promise(J=>{function vt(){if(Y.forEach(function(Dt){let At=yt.get(Dt).currentProgram;(At===void 0||At.isReady())&&Y.delete(Dt)}),Y.size===0){J(T);return}setTimeout(vt,10)}ce.get("KHR_parallel_shader_compile")!==null?vt():setTimeout(vt,10)})};let Mc=null;function Cm(T){Mc&&Mc(T)}function Hu(){Yi.stop()}function Vu(){Yi.start()}let Yi=new hp;Yi.setAnimationLoop(Cm),typeof self<"u"&&Yi.setContext(self),this.setAnimationLoop=function(T){Mc=T,ut.setAnimationLoop(T),T===null?Yi.stop():Yi.start()},ut.addEventListener("sessionstart",Hu),ut.addEventListener("sessionend",Vu),this.render=function(T,V){if(V!==void 0&&V.isCamera!==!0){Wt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;N!==null&&N.renderStart(T,V);let j=ut.enabled===!0&&ut.isPresenting===!0,Y=R!==null&&(B===null||j)&&R.begin(A,B);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(R===null||R.isCompositing()===!1)&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(V),V=ut.getCamera()),T.isScene===!0&&T.onBeforeRender(A,T,V,B),S=it.get(T,y.length),S.init(V),S.state.textureUnits=Pt.getTextureUnits(),y.push(S),Rt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Mt.setFromArrayCamera(V):Ht.setFromProjectionMatrix(Rt,Pn,V.reversedDepth),dt=this.localClippingEnabled,Tt=st.init(this.clippingPlanes,dt),E=mt.get(T,_.length),E.init(),_.push(E),this.info.render.frame++,ut.enabled===!0&&ut.isPresenting===!0){let Dt=A.xr.getDepthSensingMesh();Dt!==null&&Sc(Dt,V,-1/0,A.sortObjects)}Sc(T,V,0,A.sortObjects),E.finish(),N!==null&&N.updateLights(S.state.lightsArray),A.sortObjects===!0&&E.sort(It,Xt),Ft=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,Ft&&G.addToRenderList(E,T),this.info.autoReset===!0&&this.info.reset(),Tt===!0&&st.beginShadows();let J=S.state.shadowsArray;if(gt.render(J,T,V),Tt===!0&&st.endShadows(),(Y&&R.hasRenderPass())===!1){let Dt=E.opaque,xt=E.transmissive;if(S.setupLights(),V.isArrayCamera){let At=V.cameras;if(xt.length>0)for(let Ot=0,Zt=At.length;Ot<Zt;Ot++){let oe=At[Ot];Xu(Dt,xt,T,oe)}Ft&&G.render(T);for(let Ot=0,Zt=At.length;Ot<Zt;Ot++){let oe=At[Ot];Wu(E,T,oe,oe.viewport)}}else xt.length>0&&Xu(Dt,xt,T,V),Ft&&G.render(T),Wu(E,T,V)}B!==null&&L===0&&(Pt.updateMultisampleRenderTarget(B),Pt.updateRenderTargetMipmap(B)),Y&&R.end(A),T.isScene===!0&&T.onAfterRender(A,T,V),pt.resetDefaultState(),z=-1,F=null,y.pop(),y.length>0?(S=y[y.length-1],Pt.setTextureUnits(S.state.textureUnits),Tt===!0&&st.setGlobalState(A.clippingPlanes,S.state.camera)):S=null,_.pop(),_.length>0?E=_[_.length-1]:E=null,N!==null&&N.renderEnd()};function Sc(T,V,j,Y){if(T.visible===!1)return;if(T.layers.test(V.layers)){if(T.isGroup)j=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(V);else if(T.isLight)S.pushLight(T),T.castShadow&&S.pushShadow(T);else if(T.isSprite){let Dt=V.isArrayCamera?Mt:Ht;if(!T.frustumCulled||T.intersectsFrustum(Dt)){Y&&ct.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Rt);let xt=lt.update(T),At=T.material;At.visible&&E.push(T,xt,At,j,ct.z,null,V)}}else if(T.isMesh||T.isLine||T.isPoints){let Dt=V.isArrayCamera?Mt:Ht;if(!T.frustumCulled||T.intersectsFrustum(Dt)){let xt=lt.update(T),At=T.material;if(Y&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),ct.copy(T.boundingSphere.center)):(xt.boundingSphere===null&&xt.computeBoundingSphere(),ct.copy(xt.boundingSphere.center)),ct.applyMatrix4(T.matrixWorld).applyMatrix4(Rt)),Array.isArray(At)){let Ot=xt.groups;for(let Zt=0,oe=Ot.length;Zt<oe;Zt++){let Nt=Ot[Zt],ae=At[Nt.materialIndex];ae&&ae.visible&&E.push(T,xt,ae,j,ct.z,Nt,V)}}else At.visible&&E.push(T,xt,At,j,ct.z,null,V)}}}let vt=T.children;for(let Dt=0,xt=vt.length;Dt<xt;Dt++)Sc(vt[Dt],V,j,Y)}function Wu(T,V,j,Y){let{opaque:J,transmissive:vt,transparent:Dt}=T;S.setupLightsView(j),Tt===!0&&st.setGlobalState(A.clippingPlanes,j),Y&&Z.viewport(X.copy(Y)),J.length>0&&Vo(J,V,j),vt.length>0&&Vo(vt,V,j),Dt.length>0&&Vo(Dt,V,j),Z.buffers.depth.setTest(!0),Z.buffers.depth.setMask(!0),Z.buffers.color.setMask(!0),Z.setPolygonOffset(!1)}function Xu(T,V,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(S.state.transmissionRenderTarget[Y.id]===void 0){let Nt=ce.has("EXT_color_buffer_half_float")||ce.has("EXT_color_buffer_float");S.state.transmissionRenderTarget[Y.id]=new bn(1,1,{generateMipmaps:!0,type:Nt?Hn:pn,minFilter:_i,samples:Math.max(4,pe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:re.workingColorSpace})}let vt=S.state.transmissionRenderTarget[Y.id],Dt=Y.viewport||X;vt.setSize(Dt.z*A.transmissionResolutionScale,Dt.w*A.transmissionResolutionScale);let xt=A.getRenderTarget(),At=A.getActiveCubeFace(),Ot=A.getActiveMipmapLevel();A.setRenderTarget(vt),A.getClearColor(U),Q=A.getClearAlpha(),Q<1&&A.setClearColor(16777215,.5),A.clear(),Ft&&G.render(j);let Zt=A.toneMapping;A.toneMapping=Kn;let oe=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),S.setupLightsView(Y),Tt===!0&&st.setGlobalState(A.clippingPlanes,Y),Vo(T,j,Y),Pt.updateMultisampleRenderTarget(vt),Pt.updateRenderTargetMipmap(vt),ce.has("WEBGL_multisampled_render_to_texture")===!1){let Nt=!1;for(let ae=0,Ce=V.length;ae<Ce;ae++){let ve=V[ae],{object:ye,geometry:Ze,material:Ut,group:sn}=ve;if(Ut.side===Ie&&ye.layers.test(Y.layers)){let de=Ut.side;Ut.side=un,Ut.needsUpdate=!0,qu(ye,j,Y,Ze,Ut,sn),Ut.side=de,Ut.needsUpdate=!0,Nt=!0}}Nt===!0&&(Pt.updateMultisampleRenderTarget(vt),Pt.updateRenderTargetMipmap(vt))}A.setRenderTarget(xt,At,Ot),A.setClearColor(U,Q),oe!==void 0&&(Y.viewport=oe),A.toneMapping=Zt}function Vo(T,V,j){let Y=V.isScene===!0?V.overrideMaterial:null;for(let J=0,vt=T.length;J<vt;J++){let Dt=T[J],{object:xt,geometry:At,group:Ot}=Dt,Zt=Dt.material;Zt.allowOverride===!0&&Y!==null&&(Zt=Y),xt.layers.test(j.layers)&&qu(xt,V,j,At,Zt,Ot)}}function qu(T,V,j,Y,J,vt){N!==null&&J.isNodeMaterial&&N.setObject(T,J),T.onBeforeRender(A,V,j,Y,J,vt),T.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),J.onBeforeRender(A,V,j,Y,T,vt),J.transparent===!0&&J.side===Ie&&J.forceSinglePass===!1?(J.side=un,J.needsUpdate=!0,A.renderBufferDirect(j,V,Y,J,T,vt),J.side=Jn,J.needsUpdate=!0,A.renderBufferDirect(j,V,Y,J,T,vt),J.side=Ie):A.renderBufferDirect(j,V,Y,J,T,vt),T.onAfterRender(A,V,j,Y,J,vt)}function $u(T){let V=0;for(let j of T)j.texture!==null&&V++;return V}function vr(T,V,j){V.isScene!==!0&&(V=Lt);let Y=yt.get(T),J=S.state.lights,vt=S.state.shadowsArray,Dt=J.state.version,xt=nt.getParameters(T,J.state,vt,V,j,S.state.lightProbeGridArray),At=nt.getProgramCacheKey(xt),Ot=Y.programs;Y.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?V.environment:null,Y.fog=V.fog;let Zt=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;Y.envMap=P.get(T.envMap||Y.environment,Zt),Y.envMapRotation=Y.environment!==null&&T.envMap===null?V.environmentRotation:T.envMapRotation,Ot===void 0&&(T.addEventListener("dispose",xe),Ot=new Map,Y.programs=Ot,Y.programVariants=new Map);let oe=Ot.get(At);if(oe!==void 0){if(Y.currentProgram===oe&&Y.lightsStateVersion===Dt)return Zu(T,xt),oe}else xt.uniforms=nt.getUniforms(T),N!==null&&T.isNodeMaterial&&N.build(T,j,xt),T.onBeforeCompile(xt,A),oe=nt.acquireProgram(xt,At),Ot.set(At,oe),Y.uniforms=xt.uniforms;let Nt=Y.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Nt.clippingPlanes=st.uniform),Zu(T,xt),Y.needsLights=Dm(T),Y.lightsStateVersion=Dt,Y.needsLights&&(Nt.ambientLightColor.value=J.state.ambient,Nt.lightProbe.value=J.state.probe,Nt.sunLights.value=J.state.sun,Nt.sunLightShadows.value=J.state.sunShadow,Nt.directionalLights.value=J.state.directional,Nt.directionalLightShadows.value=J.state.directionalShadow,Nt.spotLights.value=J.state.spot,Nt.spotLightShadows.value=J.state.spotShadow,Nt.rectAreaLights.value=J.state.rectArea,Nt.ltc_1.value=J.state.rectAreaLTC1,Nt.ltc_2.value=J.state.rectAreaLTC2,Nt.pointLights.value=J.state.point,Nt.pointLightShadows.value=J.state.pointShadow,Nt.hemisphereLights.value=J.state.hemi,Nt.sunShadowMatrix.value=J.state.sunShadowMatrix,Nt.sunShadowCascade.value=J.state.sunShadowCascade,Nt.directionalShadowMatrix.value=J.state.directionalShadowMatrix,Nt.spotLightMatrix.value=J.state.spotLightMatrix,Nt.spotLightMap.value=J.state.spotLightMap,Nt.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.numLightProbeGrids=$u(S.state.lightProbeGridArray),Y.currentProgram=oe,Y.uniformsList=null,oe}function Pm(T,V,j,Y,J){let vt=yt.get(T),Dt=vt.currentProgram.id+","+Y+","+J,xt=vt.programVariants.get(Dt);return xt===void 0?(xt=vr(T,V,j),vt.programVariants.set(Dt,xt)):(vt.currentProgram=xt,vt.uniformsList=null,vt.outputColorSpace=Y,vt.toneMapping=J),xt}function Yu(T){if(T.uniformsList===null){let V=T.currentProgram.getUniforms();T.uniformsList=or.seqWithValue(V.seq,T.uniforms)}return T.uniformsList}function Zu(T,V){let j=yt.get(T);j.outputColorSpace=V.outputColorSpace,j.batching=V.batching,j.batchingColor=V.batchingColor,j.instancing=V.instancing,j.instancingColor=V.instancingColor,j.instancingMorph=V.instancingMorph,j.skinning=V.skinning,j.morphTargets=V.morphTargets,j.morphNormals=V.morphNormals,j.morphColors=V.morphColors,j.morphTargetsCount=V.morphTargetsCount,j.numClippingPlanes=V.numClippingPlanes,j.numIntersection=V.numClipIntersection,j.vertexAlphas=V.vertexAlphas,j.vertexTangents=V.vertexTangents,j.toneMapping=V.toneMapping}function Im(T,V,j,Y,J){V.isScene!==!0&&(V=Lt),Pt.resetTextureUnits();let vt=V.fog,Dt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?V.environment:null,xt=B===null?A.outputColorSpace:B.isXRRenderTarget===!0?B.texture.colorSpace:re.workingColorSpace,At=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ot=P.get(Y.envMap||Dt,At),Zt=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,oe=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Nt=!!j.morphAttributes.position,ae=!!j.morphAttributes.normal,Ce=!!j.morphAttributes.color,ve=Kn;Y.toneMapped&&(B===null||B.isXRRenderTarget===!0)&&(ve=A.toneMapping);let ye=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Ze=ye!==void 0?ye.length:0,Ut=yt.get(Y),sn=S.state.lights;if(Tt===!0&&(dt===!0||T!==F)){let Ee=T===F&&Y.id===z;st.setState(Y,T,Ee)}let de=!1,Zi=!1;Y.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==sn.state.version||J.isBatchedMesh&&Ut.batching===!1||!J.isBatchedMesh&&Ut.batching===!0||J.isBatchedMesh&&Ut.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Ut.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Ut.instancing===!1||!J.isInstancedMesh&&Ut.instancing===!0||J.isSkinnedMesh&&Ut.skinning===!1||!J.isSkinnedMesh&&Ut.skinning===!0||J.isInstancedMesh&&Ut.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ut.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ut.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ut.instancingMorph===!1&&J.morphTexture!==null||Ut.envMap!==Ot||Y.fog===!0&&Ut.fog!==vt||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==st.numPlanes||Ut.numIntersection!==st.numIntersection)||Ut.vertexAlphas!==Zt||Ut.vertexTangents!==oe||Ut.morphTargets!==Nt||Ut.morphNormals!==ae||Ut.morphColors!==Ce||Ut.morphTargetsCount!==Ze||Ut.numLightProbeGrids!==$u(S.state.lightProbeGridArray)?de=!0:(Ut.outputColorSpace!==xt||Ut.toneMapping!==ve)&&(Zi=!0):(de=!0,Ut.__version=Y.version);let Je=Ut.currentProgram;(de===!0||Zi===!0)&&(Je=Zi===!0?Pm(Y,V,J,xt,ve):vr(Y,V,J),N&&Y.isNodeMaterial&&N.onUpdateProgram(Y,Je,Ut));let Wo=!1,Ei=!1,Ji=!1,he=Je.getUniforms(),qe=Ut.uniforms;if(Z.useProgram(Je.program)&&(Wo=!0,Ei=!0,Ji=!0),Y.id!==z&&(z=Y.id,Ei=!0),Wo||F!==T){Z.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),he.setValue(H,"projectionMatrix",T.projectionMatrix),he.setValue(H,"viewMatrix",T.matrixWorldInverse);let Ge=he.map.cameraPosition;Ge!==void 0&&Ge.setValue(H,Vt.setFromMatrixPosition(T.matrixWorld)),pe.logarithmicDepthBuffer&&he.setValue(H,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&he.setValue(H,"isOrthographic",T.isOrthographicCamera===!0),F!==T&&(F=T,Ei=!0,Ji=!0)}if(Ut.needsLights&&(sn.state.sunShadowMap.length>0&&he.setValue(H,"sunShadowMap",sn.state.sunShadowMap,Pt),sn.state.directionalShadowMap.length>0&&he.setValue(H,"directionalShadowMap",sn.state.directionalShadowMap,Pt),sn.state.spotShadowMap.length>0&&he.setValue(H,"spotShadowMap",sn.state.spotShadowMap,Pt),sn.state.pointShadowMap.length>0&&he.setValue(H,"pointShadowMap",sn.state.pointShadowMap,Pt)),J.isSkinnedMesh){he.setOptional(H,J,"bindMatrix"),he.setOptional(H,J,"bindMatrixInverse");let Ee=J.skeleton;Ee&&(Ee.boneTexture===null&&Ee.computeBoneTexture(),he.setValue(H,"boneTexture",Ee.boneTexture,Pt))}J.isBatchedMesh&&(he.setOptional(H,J,"batchingTexture"),he.setValue(H,"batchingTexture",J._matricesTexture,Pt),he.setOptional(H,J,"batchingIdTexture"),he.setValue(H,"batchingIdTexture",J._indirectTexture,Pt),he.setOptional(H,J,"batchingColorTexture"),J._colorsTexture!==null&&he.setValue(H,"batchingColorTexture",J._colorsTexture,Pt));let Nn=j.morphAttributes;if((Nn.position!==void 0||Nn.normal!==void 0||Nn.color!==void 0)&&rt.update(J,j,Je),(Ei||Ut.receiveShadow!==J.receiveShadow)&&(Ut.receiveShadow=J.receiveShadow,he.setValue(H,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&V.environment!==null&&(qe.envMapIntensity.value=V.environmentIntensity),qe.dfgLUT!==void 0&&(qe.dfgLUT.value=aM()),Ei){if(he.setValue(H,"toneMappingExposure",A.toneMappingExposure),Ut.needsLights&&Lm(qe,Ji),vt&&Y.fog===!0&&ht.refreshFogUniforms(qe,vt),ht.refreshMaterialUniforms(qe,Y,ot,at,S.state.transmissionRenderTarget[T.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Ee=M,Ge=0;for(let ni of S.state.lightProbeGridArray)ni.texture!==null&&(Ee.textures[Ge]=ni.texture,Ee.min[Ge]=ni.boundingBox.min,Ee.max[Ge]=ni.boundingBox.max,Ee.resolution[Ge]=ni.resolution,Ge++);for(let ni in Ee)Ee[ni].length=Ge;qe.probesSH.value=Ee.textures,qe.probesMin.value=Ee.min,qe.probesMax.value=Ee.max,qe.probesResolution.value=Ee.resolution}or.upload(H,Yu(Ut),qe,Pt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(or.upload(H,Yu(Ut),qe,Pt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&he.setValue(H,"center",J.center),he.setValue(H,"modelViewMatrix",J.modelViewMatrix),he.setValue(H,"normalMatrix",J.normalMatrix),he.setValue(H,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let Ee=Y.uniformsGroups;for(let Ge=0,ni=Ee.length;Ge<ni;Ge++){let Ku=Ee[Ge];kt.update(Ku,Je),kt.bind(Ku,Je)}}return Je}function Lm(T,V){T.ambientLightColor.needsUpdate=V,T.lightProbe.needsUpdate=V,T.sunLights.needsUpdate=V,T.sunLightShadows.needsUpdate=V,T.directionalLights.needsUpdate=V,T.directionalLightShadows.needsUpdate=V,T.pointLights.needsUpdate=V,T.pointLightShadows.needsUpdate=V,T.spotLights.needsUpdate=V,T.spotLightShadows.needsUpdate=V,T.rectAreaLights.needsUpdate=V,T.hemisphereLights.needsUpdate=V}function Dm(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return D},this.getActiveMipmapLevel=function(){return L},this.getRenderTarget=function(){return B},this.setRenderTargetTextures=function(T,V,j){let Y=yt.get(T);Y.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),yt.get(T.texture).__webglTexture=V,yt.get(T.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,V){let j=yt.get(T);j.__webglFramebuffer=V,j.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(T,V=0,j=0){B=T,D=V,L=j;let Y=null,J=!1,vt=!1;if(T){let xt=yt.get(T);if(xt.__useDefaultFramebuffer!==void 0){Z.bindFramebuffer(H.FRAMEBUFFER,xt.__webglFramebuffer),X.copy(T.viewport),et.copy(T.scissor),W=T.scissorTest,Z.viewport(X),Z.scissor(et),Z.setScissorTest(W),z=-1;return}else if(xt.__webglFramebuffer===void 0)Pt.setupRenderTarget(T);else if(xt.__hasExternalTextures)Pt.rebindTextures(T,yt.get(T.texture).__webglTexture,yt.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let Zt=T.depthTexture;if(xt.__boundDepthTexture!==Zt){if(Zt!==null&&yt.has(Zt)&&(T.width!==Zt.image.width||T.height!==Zt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Pt.setupDepthRenderbuffer(T)}}let At=T.texture;(At.isData3DTexture||At.isDataArrayTexture||At.isCompressedArrayTexture)&&(vt=!0);let Ot=yt.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Ot[V])?Y=Ot[V][j]:Y=Ot[V],J=!0):T.samples>0&&Pt.useMultisampledRTT(T)===!1?Y=yt.get(T).__webglMultisampledFramebuffer:Array.isArray(Ot)?Y=Ot[j]:Y=Ot,X.copy(T.viewport),et.copy(T.scissor),W=T.scissorTest}else X.copy(Ct).multiplyScalar(ot).floor(),et.copy(Kt).multiplyScalar(ot).floor(),W=Jt;if(j!==0&&(Y=O),Z.bindFramebuffer(H.FRAMEBUFFER,Y)&&Z.drawBuffers(T,Y),Z.viewport(X),Z.scissor(et),Z.setScissorTest(W),J){let xt=yt.get(T.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_CUBE_MAP_POSITIVE_X+V,xt.__webglTexture,j)}else if(vt){let xt=V;for(let At=0;At<T.textures.length;At++){let Ot=yt.get(T.textures[At]);H.framebufferTextureLayer(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0+At,Ot.__webglTexture,j,xt)}}else if(T!==null&&j!==0){let xt=yt.get(T.texture);H.framebufferTexture2D(H.FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,xt.__webglTexture,j)}z=-1};function Ju(T){let V=yt.get(T);return(V.__readFormat!==T.format||V.__readType!==T.type)&&(V.__readFormat=T.format,V.__readType=T.type,V.__formatReadable=pe.textureFormatReadable(T.format),V.__typeReadable=pe.textureTypeReadable(T.type)),V}this.readRenderTargetPixels=function(T,V,j,Y,J,vt,Dt,xt=0){if(!(T&&T.isWebGLRenderTarget)){Wt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let At=yt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Dt!==void 0&&(At=At[Dt],Array.isArray(At)&&(At=At[0])),At){Z.bindFramebuffer(H.FRAMEBUFFER,At);try{let Ot=T.textures[xt],Zt=Ot.format,oe=Ot.type;T.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+xt);let Nt=Ju(Ot);if(Nt.__formatReadable===!1){Wt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Nt.__typeReadable===!1){Wt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=T.width-Y&&j>=0&&j<=T.height-J&&H.readPixels(V,j,Y,J,ft.convert(Zt),ft.convert(oe),vt)}finally{let Ot=B!==null?yt.get(B).__webglFramebuffer:null;Z.bindFramebuffer(H.FRAMEBUFFER,Ot)}}},this.readRenderTargetPixelsAsync=async function(T,V,j,Y,J,vt,Dt,xt=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let At=yt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Dt!==void 0&&(At=At[Dt],Array.isArray(At)&&(At=At[0])),At)if(V>=0&&V<=T.width-Y&&j>=0&&j<=T.height-J){Z.bindFramebuffer(H.FRAMEBUFFER,At);let Ot=T.textures[xt],Zt=Ot.format,oe=Ot.type;T.textures.length>1&&H.readBuffer(H.COLOR_ATTACHMENT0+xt);let Nt=Ju(Ot);if(Nt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Nt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ae=H.createBuffer();H.bindBuffer(H.PIXEL_PACK_BUFFER,ae),H.bufferData(H.PIXEL_PACK_BUFFER,vt.byteLength,H.STREAM_READ),H.readPixels(V,j,Y,J,ft.convert(Zt),ft.convert(oe),0),H.bindBuffer(H.PIXEL_PACK_BUFFER,null);let Ce=B!==null?yt.get(B).__webglFramebuffer:null;Z.bindFramebuffer(H.FRAMEBUFFER,Ce);let ve=H.fenceSync(H.SYNC_GPU_COMMANDS_COMPLETE,0);return H.flush(),await If(H,ve,4),H.bindBuffer(H.PIXEL_PACK_BUFFER,ae),H.getBufferSubData(H.PIXEL_PACK_BUFFER,0,vt),H.bindBuffer(H.PIXEL_PACK_BUFFER,null),H.deleteBuffer(ae),H.deleteSync(ve),vt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,V=null,j=0){let Y=Math.pow(2,-j),J=Math.floor(T.image.width*Y),vt=Math.floor(T.image.height*Y),Dt=V!==null?V.x:0,xt=V!==null?V.y:0;Pt.setTexture2D(T,0),H.copyTexSubImage2D(H.TEXTURE_2D,j,0,0,Dt,xt,J,vt),Z.unbindTexture()},this.copyTextureToTexture=function(T,V,j=null,Y=null,J=0,vt=0){let Dt,xt,At,Ot,Zt,oe,Nt,ae,Ce,ve=T.isCompressedTexture?T.mipmaps[vt]:T.image;if(j!==null)Dt=j.max.x-j.min.x,xt=j.max.y-j.min.y,At=j.isBox3?j.max.z-j.min.z:1,Ot=j.min.x,Zt=j.min.y,oe=j.isBox3?j.min.z:0;else{let he=Math.pow(2,-J);Dt=Math.floor(ve.width*he),xt=Math.floor(ve.height*he),T.isDataArrayTexture?At=ve.depth:T.isData3DTexture?At=Math.floor(ve.depth*he):At=1,Ot=0,Zt=0,oe=0}Y!==null?(Nt=Y.x,ae=Y.y,Ce=Y.z):(Nt=0,ae=0,Ce=0);let ye=ft.convert(V.format),Ze=ft.convert(V.type),Ut;V.isData3DTexture?(Pt.setTexture3D(V,0),Ut=H.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Pt.setTexture2DArray(V,0),Ut=H.TEXTURE_2D_ARRAY):(Pt.setTexture2D(V,0),Ut=H.TEXTURE_2D),Z.activeTexture(H.TEXTURE0),Z.pixelStorei(H.UNPACK_FLIP_Y_WEBGL,V.flipY),Z.pixelStorei(H.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Z.pixelStorei(H.UNPACK_ALIGNMENT,V.unpackAlignment);let sn=Z.getParameter(H.UNPACK_ROW_LENGTH),de=Z.getParameter(H.UNPACK_IMAGE_HEIGHT),Zi=Z.getParameter(H.UNPACK_SKIP_PIXELS),Je=Z.getParameter(H.UNPACK_SKIP_ROWS),Wo=Z.getParameter(H.UNPACK_SKIP_IMAGES);Z.pixelStorei(H.UNPACK_ROW_LENGTH,ve.width),Z.pixelStorei(H.UNPACK_IMAGE_HEIGHT,ve.height),Z.pixelStorei(H.UNPACK_SKIP_PIXELS,Ot),Z.pixelStorei(H.UNPACK_SKIP_ROWS,Zt),Z.pixelStorei(H.UNPACK_SKIP_IMAGES,oe);let Ei=T.isDataArrayTexture||T.isData3DTexture,Ji=V.isDataArrayTexture||V.isData3DTexture;if(T.isDepthTexture){let he=yt.get(T),qe=yt.get(V),Nn=yt.get(he.__renderTarget),Ee=yt.get(qe.__renderTarget);Z.bindFramebuffer(H.READ_FRAMEBUFFER,Nn.__webglFramebuffer),Z.bindFramebuffer(H.DRAW_FRAMEBUFFER,Ee.__webglFramebuffer);for(let Ge=0;Ge<At;Ge++)Ei&&(H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,yt.get(T).__webglTexture,J,oe+Ge),H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,yt.get(V).__webglTexture,vt,Ce+Ge)),H.blitFramebuffer(Ot,Zt,Ot+Dt,Zt+xt,Nt,ae,Nt+Dt,ae+xt,H.DEPTH_BUFFER_BIT,H.NEAREST);Z.bindFramebuffer(H.READ_FRAMEBUFFER,null),Z.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else if(J!==0||T.isRenderTargetTexture||yt.has(T)){let he=yt.get(T),qe=yt.get(V);Z.bindFramebuffer(H.READ_FRAMEBUFFER,I),Z.bindFramebuffer(H.DRAW_FRAMEBUFFER,k);for(let Nn=0;Nn<At;Nn++)Ei?H.framebufferTextureLayer(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,he.__webglTexture,J,oe+Nn):H.framebufferTexture2D(H.READ_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,he.__webglTexture,J),Ji?H.framebufferTextureLayer(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,qe.__webglTexture,vt,Ce+Nn):H.framebufferTexture2D(H.DRAW_FRAMEBUFFER,H.COLOR_ATTACHMENT0,H.TEXTURE_2D,qe.__webglTexture,vt),J!==0?H.blitFramebuffer(Ot,Zt,Ot+Dt,Zt+xt,Nt,ae,Nt+Dt,ae+xt,H.COLOR_BUFFER_BIT,H.NEAREST):Ji?H.copyTexSubImage3D(Ut,vt,Nt,ae,Ce+Nn,Ot,Zt,Dt,xt):H.copyTexSubImage2D(Ut,vt,Nt,ae,Ot,Zt,Dt,xt);Z.bindFramebuffer(H.READ_FRAMEBUFFER,null),Z.bindFramebuffer(H.DRAW_FRAMEBUFFER,null)}else Ji?T.isDataTexture||T.isData3DTexture?H.texSubImage3D(Ut,vt,Nt,ae,Ce,Dt,xt,At,ye,Ze,ve.data):V.isCompressedArrayTexture?H.compressedTexSubImage3D(Ut,vt,Nt,ae,Ce,Dt,xt,At,ye,ve.data):H.texSubImage3D(Ut,vt,Nt,ae,Ce,Dt,xt,At,ye,Ze,ve):T.isDataTexture?H.texSubImage2D(H.TEXTURE_2D,vt,Nt,ae,Dt,xt,ye,Ze,ve.data):T.isCompressedTexture?H.compressedTexSubImage2D(H.TEXTURE_2D,vt,Nt,ae,ve.width,ve.height,ye,ve.data):H.texSubImage2D(H.TEXTURE_2D,vt,Nt,ae,Dt,xt,ye,Ze,ve);Z.pixelStorei(H.UNPACK_ROW_LENGTH,sn),Z.pixelStorei(H.UNPACK_IMAGE_HEIGHT,de),Z.pixelStorei(H.UNPACK_SKIP_PIXELS,Zi),Z.pixelStorei(H.UNPACK_SKIP_ROWS,Je),Z.pixelStorei(H.UNPACK_SKIP_IMAGES,Wo),vt===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&H.generateMipmap(Ut),Z.unbindTexture()},this.initRenderTarget=function(T){yt.get(T).__webglFramebuffer===void 0&&Pt.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Pt.setTextureCube(T,0):T.isData3DTexture?Pt.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Pt.setTexture2DArray(T,0):Pt.setTexture2D(T,0),Z.unbindTexture()},this.resetState=function(){D=0,L=0,B=null,Z.reset(),pt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Pn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=re._getDrawingBufferColorSpace(t),e.unpackColorSpace=re._getUnpackColorSpace()}};var lM=[53,196,106].map(i=>(i/255)**2.2),Mp=4,iu=4,su=[.477,.467,.445],ru=[.716,.716,.716],Io=[.493,.468,.427],cM=Uint8Array.from({length:1025},(i,t)=>255*(t/1024)**(1/2.2));function lr(i,t,e,n,s,r){let o=i[t],a=i[t+1],l=i[t+2],c=i[t+3],h=e[n],d=e[n+1],u=e[n+2],f=e[n+3];s[r]=o*h-a*d-l*u-c*f,s[r+1]=o*d+a*h+l*f-c*u,s[r+2]=o*u-a*f+l*h+c*d,s[r+3]=o*f+a*u-l*d+c*h}function hM(i,t,e,n,[s,r,o],a,l){let c=e[n],h=e[n+1],d=e[n+2],u=e[n+3],f=2*(d*o-u*r),m=2*(u*s-h*o),v=2*(h*r-d*s);a[l]=i[t]+s+c*f+d*v-u*m,a[l+1]=i[t+1]+r+c*m+u*f-h*v,a[l+2]=i[t+2]+o+c*v+h*m-d*f}var Vn=class{constructor({parents:t,offsets:e}){Object.assign(this,{parents:t,offsets:e}),this.turned=new Float32Array(4*t.length),this.places=new Float32Array(3*t.length)}pose(t,e){this.parents.forEach((n,s)=>{n<0?this.turned.set(e.subarray(4*s,4*s+4),4*s):lr(this.turned,4*n,e,4*s,this.turned,4*s)}),this.put(t)}put(t){this.parents.forEach((e,n)=>{e<0?this.places.set(t,3*n):hM(this.places,3*e,this.turned,4*e,this.offsets[n],this.places,3*n)})}transforms(t,e){let{turned:n,places:s}=this,r=new Float32Array(12);for(let o=0;o<s.length/3;o++){let a=n[4*o],l=n[4*o+1],c=n[4*o+2],h=n[4*o+3];r[0]=1-2*(c*c+h*h),r[1]=2*(l*c-a*h),r[2]=2*(l*h+a*c),r[3]=s[3*o],r[4]=2*(l*c+a*h),r[5]=1-2*(l*l+h*h),r[6]=2*(c*h-a*l),r[7]=s[3*o+1],r[8]=2*(l*h-a*c),r[9]=2*(c*h+a*l),r[10]=1-2*(l*l+c*c),r[11]=s[3*o+2];for(let d=0;d<12;d+=4)for(let u=0;u<4;u++)e[12*o+d+u]=r[d]*t[12*o+u]+r[d+1]*t[12*o+4+u]+r[d+2]*t[12*o+8+u]+(u===3?r[d+3]:0)}}};function Lo(i){let{low:t,size:e}=i,n=Ke(i.marks,Uint8Array),s=Ke(i.normals,Int8Array),r=Float32Array.from(Ke(i.points,Uint16Array),(a,l)=>t[l%3]+e[l%3]*a/65535),o=Float32Array.from(Ke(i.colors,Uint8Array),a=>(a/255)**2.2);return{points:r,tones:o,marks:n,inverse:Ke(i.inverse,Float32Array),normals:Float32Array.from(s,a=>a/127),triangles:Ke(i.triangles,r.length>3*65535?Uint32Array:Uint16Array),hosts:Ke(i.joints,i.parents.length<256?Uint8Array:Uint16Array),shares:Float32Array.from(Ke(i.weights,Uint8Array),a=>a/255)}}var ou=({marks:i},t)=>i[iu*t+2]/255*(i[iu*t+3]/255)**2.2;function uM(i,t,e=.06){let n=new Map,s=[],r=l=>{let c=[0,1,2].map(h=>Math.round(i[3*l+h]/e)).join();return n.has(c)||n.set(c,l),n.get(c)},o=Uint32Array.from({length:i.length/3},(l,c)=>r(c)),a=new Set;for(let l=0;l<t.length;l+=3){let c=[...t.subarray(l,l+3)].map(d=>o[d]),h=[...c].sort().join();new Set(c).size<3||a.has(h)||(a.add(h),s.push(...c))}return s}var Vi=class{constructor(t,e,n,s){Object.assign(this,{skeleton:t,plain:n,light:e.clone().normalize(),touching:{},scale:1,...Lo(t.mesh)}),this.tree=new Vn(t),this.matrices=new Float32Array(this.inverse.length),s&&this.tones.forEach((c,h)=>this.tones[h]+=s[h%3]*ou(this,Math.floor(h/3)));let r=this.points.length,o=new Ue(this.triangles,1),a=(c,...h)=>new Ue(c,3,...h).setUsage(Oh);this.geometry=new $e().setIndex(o),this.position=a(new Float32Array(r)),this.normal=a(new Float32Array(r)),this.shown=this.tones.slice(),this.color=n?a(new Uint8Array(r),!0):a(this.shown),this.geometry.setAttribute("position",this.position).setAttribute("color",this.color),n||this.geometry.setAttribute("normal",this.normal);let l=n?new hn({vertexColors:!0,fog:!1}):new lo({vertexColors:!0,roughness:.62,metalness:0});this.mesh=new we(this.geometry,l),this.mesh.frustumCulled=!1,this.mesh.castShadow=this.mesh.receiveShadow=!0,this.flat=new $e().setIndex(uM(this.points,this.triangles)).setAttribute("position",this.position),this.paint()}shadow(t){let{x:e,y:n,z:s}=this.light,r=new hn({color:t,fog:!1,side:Ie}),o=new we(this.flat,r);return o.frustumCulled=o.matrixAutoUpdate=!1,o.matrix.set(1,-e/n,0,0,0,0,0,.003,0,-s/n,1,0,0,0,0,1),o}pose(t,e){this.tree.pose(t,e),this.skin(this.tree)}skin(t){let{points:e,normals:n,hosts:s,shares:r,matrices:o}=this,a=this.position.array,l=this.normal.array;t.transforms(this.inverse,o);for(let c=0,h=0;h<e.length;c+=Mp,h+=3){let d=e[h],u=e[h+1],f=e[h+2],m=n[h],v=n[h+1],p=n[h+2],g=0,x=0,b=0,M=0,E=0,S=0;for(let y=c;y<c+Mp;y++){let R=r[y],A=12*s[y];R!==0&&(g+=R*(o[A]*d+o[A+1]*u+o[A+2]*f+o[A+3]),x+=R*(o[A+4]*d+o[A+5]*u+o[A+6]*f+o[A+7]),b+=R*(o[A+8]*d+o[A+9]*u+o[A+10]*f+o[A+11]),M+=R*(o[A]*m+o[A+1]*v+o[A+2]*p),E+=R*(o[A+4]*m+o[A+5]*v+o[A+6]*p),S+=R*(o[A+8]*m+o[A+9]*v+o[A+10]*p))}let _=1/(Math.sqrt(M*M+E*E+S*S)||1);a[h]=g,a[h+1]=x,a[h+2]=b,l[h]=M*_,l[h+1]=E*_,l[h+2]=S*_}this.position.needsUpdate=this.normal.needsUpdate=!0,this.plain&&this.shade()}setContacts(t){let e=["left","right"].every(n=>!!this.touching[n]==!!t[n]);this.touching={...t},e||this.paint()}paint(){let{tones:t,shown:e,marks:n,touching:{left:s,right:r}}=this;e.set(t);for(let o=0,a=0;o<n.length;o+=iu,a+=3){let l=(s?n[o]:0)+(r?n[o+1]:0),c=(n[o+3]/255)**2.2;if(l)for(let h=0;h<3;h++)e[a+h]+=l/255*(c*lM[h]-e[a+h])}this.plain&&this.shade(),this.color.needsUpdate=!0}shade(){let{shown:t}=this,e=this.color.array,n=this.normal.array,{x:s,y:r,z:o}=this.light;for(let a=0;a<e.length;a+=3){let l=.5+.5*n[a+1],c=Math.max(n[a]*s+n[a+1]*r+n[a+2]*o,0);for(let h=0;h<3;h++)e[a+h]=cM[Math.min(1024*t[a+h]*(Io[h]+l*(ru[h]-Io[h])+c*su[h]),1024)|0]}this.color.needsUpdate=!0}dispose(){this.geometry.dispose(),this.flat.dispose()}};var hr={linear:i=>i,smooth:i=>i*i*(3-2*i),smoother:i=>i*i*i*(i*(6*i-15)+10),in:i=>i*i,out:i=>i*(2-i),jump:i=>+(i>=1)};function Le(i){let t=Math.floor(i),e=i-t;return e<.5||e===.5&&t%2===0?t:t+1}var Sp=(i,t,e)=>Math.min(Math.max(i,t),e),Do=(i,t)=>Math.sqrt(i*i+t*t),dM=i=>i.slice(1).map((t,e)=>[i[e],t]),fM=i=>Math.atan2(Math.sin(i),Math.cos(i));function cr(i,t){let e=0,n=i.length;for(;e<n;){let s=e+n>>1;t<i[s]?n=s:e=s+1}return e}function ur(i,t,e){let n=cr(i,e)-1,s=Math.max(n,0);return n<0||n===i.length-1?[s,s,0]:[n,n+1,hr[t[n]]((e-i[n])/(i[n+1]-i[n]))]}function Wi({times:i,values:t,easings:e},n){let[s,r,o]=ur(i,e,n);return t[s]+o*(t[r]-t[s])}var $l=class{constructor(t,e,n){let s=[0,1],r=dM(t),o=r.map(([c,h])=>Do(h[0]-c[0],h[1]-c[1])),a=r.map(([c,h],d)=>s.map(u=>(h[u]-c[u])/o[d])),l=[a[0]];for(let c=1;c<o.length;c++){let h=o[c-1],d=o[c];l.push(s.map(u=>(a[c-1][u]*d+a[c][u]*h)/(h+d)))}if(l.push(a.at(-1)),o.length>1){let c=o.length;l[0]=s.map(h=>2*a[0][h]-l[1][h]),l[c]=s.map(h=>2*a.at(-1)[h]-l[c-1][h])}Object.assign(this,{rules:n,x:[t[0][0]],z:[t[0][1]],at:[0],knots:[0]}),o.forEach((c,h)=>{let d=Math.ceil(c/n.SPACING-1e-9);for(let u=1;u<=d;u++){let f=u/d,m=1-f,[v,p]=s.map(g=>{let x=t[h][g],b=t[h+1][g];return e?m*m*(1+2*f)*x+f*f*(1+2*m)*b+m*f*(m*(l[h][g]*c)-f*(l[h+1][g]*c)):m*x+f*b});this.at.push(this.at.at(-1)+Do(v-this.x.at(-1),p-this.z.at(-1))),this.x.push(v),this.z.push(p)}this.knots.push(this.at.at(-1))}),this.length=this.at.at(-1)}point(t){let{x:e,z:n,at:s}=this;if(t>=this.length)return[e.at(-1),n.at(-1)];let r=Math.max(cr(s,t),1),o=Math.max(t-s[r-1],0)/(s[r]-s[r-1]);return[e[r-1]+o*(e[r]-e[r-1]),n[r-1]+o*(n[r]-n[r-1])]}tangent(t){let e=Sp(t,0,this.length),{SPACING:n}=this.rules,[s,r]=this.point(Math.max(e-n,0)),[o,a]=this.point(e+n),l=Math.max(Do(o-s,a-r),1e-12);return[(o-s)/l,(a-r)/l]}},Yl=class{constructor(t,e,n,s,r){let{rules:o}=t,{FPS:a,FASTEST:l,LONGEST:c,SETTLE:h}=o,d=g=>g.sort(([x,b],[M,E])=>x-M||b-E);Object.assign(this,{curve:t,rules:o,speeds:e,distance:[0],speed:[0],stop:0,until:0,late:[]}),this.pauses=d(s.filter(g=>g.time!=null).map(g=>[g.time,g.seconds])),this.stops=d(s.filter(g=>g.distance!=null).map(g=>[Math.min(g.distance,t.length),g.seconds])),this.stops.push([t.length,1/0]),n.forEach(([g,x],b)=>{let M=0,E=l;if(this.walk(g,E,x).reached)for(let S=0;S<30;S++){let _=(M+E)/2;this.walk(g,_,x).reached?E=_:M=_}else this.late.push(b);this.keep(this.walk(g,E,c))}),this.keep(this.walk(t.length,1,r??c));let{distance:u,speed:f}=this,m=u.at(-1);this.end=m>=t.length-1e-9?(u.length-1)/a:null;let v=r??(this.end===null?c:Math.min(this.end+h,c)),p=Le(v*a)+1;for(;u.length<p;)u.push(m),f.push(0);u.length=f.length=p}keep({distances:t,speeds:e,stop:n,until:s}){for(let r=0;r<t.length;r++)this.distance.push(t[r]),this.speed.push(e[r]);Object.assign(this,{stop:n,until:s})}walk(t,e,n){let{FPS:s,ACCELERATION:r}=this.rules,o=this.distance.length,a=[],l=[],c=this.distance.at(-1),h=this.speed.at(-1),{stop:d,until:u}=this;for(;c<t-1e-9;){let f=(o+a.length)/s,[m,v]=this.stops[d];if(f>n+1e-9)return{distances:a,speeds:l,stop:d,until:u,reached:!1};h=Math.max(Math.min(h+r/s,e*this.natural(f)),h-2*r/s,0),h=Math.min(h,Math.sqrt(2*r*Math.max(m-c,0)));for(let[p,g]of this.pauses)f<p+g&&(h=Math.min(h,r*Math.max(p-f,0)));f<u&&(h=0),c=Math.min(c+h/s,m),c>=m-1e-9&&f>=u&&d<this.stops.length-1&&(u=f+v,d+=1),a.push(c),l.push(h)}return{distances:a,speeds:l,stop:d,until:u,reached:!0}}natural(t){return Wi(this.speeds,t)}};function dr(i,t,e){let{BEHIND:n,BEFORE:s}=i.rules,{at:r,x:o,z:a}=i,l=Math.max(cr(r,e-n)-1,0),c=Math.min(cr(r,e+s),r.length-1),h=e,d=1/0;for(let u=l;u<c;u++){let f=r[u+1]-r[u],m=(o[u+1]-o[u])/f,v=(a[u+1]-a[u])/f,p=Sp((t[0]-o[u])*m+(t[1]-a[u])*v,0,f),g=Do(o[u]+p*m-t[0],a[u]+p*v-t[1]);g<d&&(h=r[u]+p,d=g)}return h}var Zl=class{constructor(t,e,n,s){Object.assign(this,{curve:t,direction:e,look:n,easings:s.map(()=>"linear")});let r=o=>this.rule(o,t.point(o));this.offsets=s.map((o,a)=>o===null?0:fM(o-r(t.knots[a])))}rule(t,e){return this.look?Math.atan2(this.look[0]-e[0],this.look[1]-e[1]):Math.atan2(...this.direction??this.curve.tangent(t))}angle(t,e){let[n,s,r]=ur(this.curve.knots,this.easings,t);return this.rule(t,e)+this.offsets[n]+r*(this.offsets[s]-this.offsets[n])}};function bp(i,t,e,n){let{curve:s,rules:r}=i,o=i.distance.length-1,a=i.distance[Math.min(e,o)],l=Math.min(e+Le(r.LEAD*r.FPS),o),c=dr(s,n,a),h=c+i.distance[l]-a,d=t.angle(h,n),u=i.speed[l],[f,m]=s.point(c),[v,p]=s.tangent(h),g=a-c,x=f-n[0],b=m-n[1],M=r.ALONG*g*v+r.ACROSS*x,E=r.ALONG*g*p+r.ACROSS*b,[S,_]=u===0?[r.STANDING,r.GENTLE]:[1,r.LARGEST],y=Math.min(S,_/Math.max(Do(M,E),1e-12));return u===0&&(y*=Math.max(1-r.NEAR/Math.max(Math.sqrt(g**2+x**2+b**2),1e-12),0)),{velocity:[u*v+y*M,u*p+y*E],facing:[Math.sin(d),Math.cos(d)]}}var pM={WATCHED:600,SHOWN:240,AGAIN:120},fr=["left","right"],ti=(i,t)=>i.map((e,n)=>e-t[n]),Kl=(i,t)=>i.reduce((e,n,s)=>e+n*t[s],0),Wn=i=>Math.hypot(...i),du=(i,t,e=1)=>i.map((n,s)=>n+e*t[s]),_s=([i,,t])=>[i,t],Pp=(i,t)=>Math.max(1,Le(i*t/2)),mM=i=>i.reduce((t,e)=>t+e,0),lu=i=>i.reduce((t,e)=>Math.min(t,e),1/0);function au(i,t){let e=[...i].sort((r,o)=>r-o),n=t*(e.length-1),s=Math.floor(n);return e.length?e[s]+(n-s)*((e[s+1]??e[s])-e[s]):NaN}function Jl(i,t){let e=Math.floor((t-i.length)/2);return Array.from({length:t},(n,s)=>i[s-e]??NaN)}var cu=(i,t,e)=>{let n=Pp(e,t);return i.map((s,r)=>r<n||r+n>=i.length?null:ti(i[r+n],i[r-n]).map(o=>o*t/(2*n)))},hu=(i,t,e)=>cu(i,t,e).map(n=>n?Wn(n):NaN);function wp(i,t,e){let n=Pp(t,e);return i.map((s,r)=>r>=n&&r+n<i.length&&i.slice(r-n,r+n+1).every(Boolean))}var Ep=(i,t)=>i.map((e,n)=>t[n]?e:NaN),Ap=(i,t,{POINTS:e})=>Array.from({length:e-1},(n,s)=>du(i,ti(t,i),(s+1)/(e-1))),No=(i,t)=>Math.sqrt(lu(i.map(e=>lu(t.map(n=>(e[0]-n[0])**2+(e[1]-n[1])**2+(e[2]-n[2])**2)))));function Tp(i,t,e=1){let n=i;for(let s=0;s<t;s++)n=n.slice(e).map((r,o)=>ti(r,n[o]));return n}function*gM(i,t,e){let{LOW:n,FLAT:s,TOUCH:r,STANCE:o,BEHIND:a,STROLL:l,STILL:c,SLOW:h,REST:d,ALIKE:u,LIFTED:f}=e,{hips:m,left_toe:v,right_toe:p}=i,g=au(v.map((C,N)=>Math.min(C[1],p[N][1])),.05),x=m.length,b=cu(m.map(_s),t,r),M=b.map(C=>C?Wn(C):NaN),E=[],S=[];for(let C of fr){let N=i[`${C}_toe`],O=i[`${C}_foot`],I=N.map(W=>W[1]-g<n),k=O.map(W=>W[1]),D=I.some(Boolean)?au(k.filter((W,U)=>I[U]),.25):lu(k),L=I.map((W,U)=>W&&k[U]-D<s),B=cu(N,t,r),z=L.map((W,U)=>W&&B[U]&&Kl(_s(B[U]),b[U])/Math.max(M[U],.05)<a*Math.max(M[U],l)),F=hu(O,t,r),X=B.map((W,U)=>W?Math.min(Wn(W),F[U]):NaN);for(let[W,U]of[["slide",o],["short slide",r]])yield[W,`${C}_toe`,Ep(X,wp(z,U,t))];let et=L.map((W,U)=>W&&B[U]&&Wn(B[U])<c);yield["pivot",`${C}_foot`,Ep(hu(O.map(_s),t,r),wp(et,r,t))],E.push(au(N.filter((W,U)=>B[U]&&Wn(B[U])<h).map(W=>W[1]),.05)),S.push(B.map((W,U)=>W?Wn(ti(_s(W),b[U])):NaN))}let _=2*Math.max(1,Le(d*t/2))+1,y=(C,N)=>mM(C.slice(N,N+_))/_,R=S[0].map((C,N)=>Math.max(C,S[1][N]));yield["drift","hips",Jl(Array.from({length:Math.max(x-_+1,0)},(C,N)=>{let O=y(M,N);return y(R,N)<u*O?O:NaN}),x)];let A=Math.abs(E[0]-E[1]);yield["floor",`${fr[+(E[0]>E[1])]}_toe`,m.map(()=>A<f?A:NaN)]}function*_M(i,t,{STEP:e}){let n=Math.max(1,Le(e*t)),s=Math.max(3,Le(.2*t)),r=i.hips.length;for(let[o,a]of Object.entries(i)){if(/(hip|shoulder)$/.test(o))continue;yield["pop",o,Jl(Tp(a,3,n).map(h=>Wn(h)*(t/n)**3),r)];let l=Tp(a,4).map(h=>Wn(h)/16),c=[];for(let h=0;h+s<=l.length;h++){let d=l.slice(h,h+s).sort((u,f)=>u-f);c.push(d[s-1>>1]*(Math.min(t,60)/30)**2)}yield["shake",o,Jl(c,r)]}for(let o of fr)for(let[a,l,c]of[["hip","knee","foot"],["shoulder","elbow","hand"]]){let h=i[`${o}_${l}`].map((u,f)=>{let m=ti(u,i[`${o}_${a}`][f]),v=ti(i[`${o}_${c}`][f],u);return Math.atan2(Wn(rn(m,v)),Kl(m,v))*180/Math.PI}),d=h.slice(2*n).map((u,f)=>Math.abs(u-2*h[f+n]+h[f])*(t/n)**2);yield["bend",`${o}_${l}`,Jl(d,r)],yield["fold",`${o}_${l}`,h]}}function xM(i,t,e){let n=(o,a)=>Ap(i[o][t],i[a][t],e),s=Ip(du(i.left_shoulder[t],i.right_shoulder[t]),.5),r=[["elbow","hand"],["hip","knee"],["knee","foot"]];return{trunk:[...n("hips","chest"),...Ap(i.chest[t],s,e)],limbs:Object.fromEntries(fr.flatMap(o=>r.map(([a,l])=>[`${o}_${l}`,n(`${o}_${a}`,`${o}_${l}`)])))}}var Ip=(i,t)=>i.map(e=>t*e);function yM(i,t,{trunk:e,limbs:n}){let s=[],r=Rp(ti(i.left_hip[t],i.right_hip[t])),o=rn(r,[0,1,0]);for(let a of fr){let l=n[`${a}_hand`];s.push(["body",`${a}_hand and trunk`,No(l,e)]),s.push(["body",`${a}_hand and thigh`,Math.min(No(l,n.left_knee),No(l,n.right_knee))])}s.push(["body","shins",No(n.left_foot,n.right_foot)]);for(let a of fr){let l=i[`${a}_hip`][t],c=Rp(ti(i[`${a}_foot`][t],l)),h=ti(i[`${a}_knee`][t],l);s.push(["knee",`${a}_knee`,-Kl(du(h,c,-Kl(h,c)),o)])}return s}var Rp=i=>Ip(i,1/Math.max(Wn(i),1e-12));function uu(i,t,e,n,s,r,o){let a=r.least.includes(i),l=e.map((h,d)=>a?n[d]-h:h-n[d]),c=[];return l.forEach((h,d)=>{if(!(h>0))return;let u=c[c.length-1];u&&d-u[u.length-1]<=r.JOIN*s?u.push(d):c.push([d])}),c.map(h=>{let d=h.reduce((m,v)=>l[v]>l[m]?v:m),u=e[d],f=n[d];return{kind:i,joint:t,start:h[0]/s,end:(h[h.length-1]+1)/s,value:u,limit:f,unit:r.units[i],characters:o,excess:a?f/Math.max(u,1e-6):u/f}})}function vM(i,t,e,n,s,r,o){let a=Math.min(e.at.hips.length,n.at.hips.length),l=v=>Array(a).fill(v),c=`of ${i} and ${t}`,h=e.at.hips.slice(0,a).map((v,p)=>Wn(ti(_s(v),_s(n.at.hips[p])))),d=({shape:v},p)=>Object.values(v[p].limbs).flat(),u=o===void 0?[]:uu("apart",`hips ${c}`,h,l(o),s,r,[i,t]),f={trunk:(v,p)=>v.shape[p].trunk,limb:d},m=[["trunk","trunk",e,n],["limb","trunk",e,n],["limb","trunk",n,e],["limb","limb",e,n]];for(let[v,p,g,x]of m){let b=h.map((M,E)=>M>2?NaN:No(f[v](g,E),f[p](x,E)));u.push(...uu("body",`${v} and ${p} ${c}`,b,l(r.others[`${v} ${p}`]),s,r,[i,t]))}return u}function Lp(i,t){let e=[],n=0,s=null,r=null,o=0,{WATCHED:a,SHOWN:l,AGAIN:c}=pM;return{take(h,d,u){h!==s&&([e,n,r]=[[],0,null]),s=h+1,e.push({root:d,rotations:u}),e.length>a&&e.shift(),n+=1},look(h,d){if(!r&&n>=c){let u=[...e];[n,o,r]=[0,u.length,fu([{count:u.length,pose:f=>u[f]}],i,d,t)]}for(;r&&performance.now()<h;){let{done:u,value:f}=r.next();if(!u)continue;r=null;let m=o/d;return f.filter(({end:p})=>(m-p)*d<l).map(p=>({...p,start:p.start-m,end:p.end-m}))}return null}}}function*fu(i,t,e,n,s){let r=new Vn(t),o={...n.roles,chest:n.chest},a=[],l=[];for(let[c,h]of i.entries()){let d=Object.fromEntries(Object.keys(o).map(b=>[b,[]])),u=[],f=[];for(let b=0;b<h.count;b++,yield){let{root:M,rotations:E}=h.pose(b);r.pose(M,E);for(let[S,_]of Object.entries(o))d[S].push([...r.places.subarray(3*_,3*_+3)]);u.push(xM(d,b,n)),f.push(yM(d,b,u[b]))}if(!h.count)continue;let m={at:d,shape:u},v=hu(d.hips.map(_s),e,.5),{chest:p,...g}=d;l.push([c,m]);let x=f[0].map(([b,M],E)=>[b,M,f.map(S=>S[E][2])]);for(let b of[gM(g,e,n),_M(g,e,n),x])for(let[M,E,S]of b){let[_,y]=n.limits[M][E.replace(/^(left|right)_/,"")];a.push(...uu(M,E,S,v.map(R=>R>n.RUNNING?y:_),e,n,[c])),yield}}for(let[c,[h,d]]of l.entries())for(let[u,f]of l.slice(0,c))a.push(...vM(u,h,f,d,e,n,s)),yield;return a.sort((c,h)=>c.start-h.start)}var Cp=i=>i>=100?String(Math.round(i)):String(Number(i.toPrecision(3))),Uo=({kind:i,joint:t,start:e,end:n,value:s,limit:r,unit:o,characters:[a,l]},c,h=[])=>`${i}: ${h.length>1&&l===void 0?`${h[a]}, `:""}${t.replaceAll("_"," ")}, ${e.toFixed(2)} to ${n.toFixed(2)} s, ${Cp(s)} ${c.least.includes(i)?"<":">"} ${Cp(r)} ${o}`;function Dp(i){let t=new Map;for(let{kind:e,joint:n}of i)t.set(e,(t.get(e)??new Set).add(n.replaceAll("_"," ")));return[...t].map(([e,n])=>`${e}: ${[...n].join(", ")}`).join("; ")}function Np(i,t,e){if(!i.length)return"No defects found.";let n=new Map;for(let{kind:r}of i)n.set(r,(n.get(r)??0)+1);return`Defects: ${[...n].sort(([,r],[,o])=>o-r).map(([r,o])=>`${o} × ${r}`).join(", ")}; the worst: ${Uo(i.reduce((r,o)=>o.excess>r.excess?o:r),t,e)}`}var jl=[[110,26],[196,172],[24,172]],MM=["#7b68c4","#2fa596","#d6598b"],SM=`.tk-triangle{width:220px;color:#2b323b;font:13px system-ui,sans-serif;touch-action:none;user-select:none}
.tk-triangle svg{display:block;cursor:pointer;overflow:visible}.tk-triangle svg:focus{outline:none}.tk-triangle svg:focus-visible .marker{stroke:#7b68c4}
.tk-triangle text{font:600 12px system-ui,sans-serif;fill:#2b323b}.tk-triangle .share{font-weight:400;fill:#6d7580}`;function bM([i,t]){let[[e,n],[s,r],[o,a]]=jl,l=(r-a)*(e-o)+(o-s)*(n-a),c=((r-a)*(i-o)+(o-s)*(t-a))/l,h=((a-n)*(i-o)+(e-o)*(t-a))/l,d=[c,h,1-c-h].map(f=>Math.max(f,0)),u=d.reduce((f,m)=>f+m);return d.map(f=>f/u)}function wM({model:i,el:t}){let e=["middle","end","start"],n=[[110,12],[216,194],[4,194]];t.innerHTML=`<style>${SM}</style><div class="tk-triangle"><svg viewBox="0 0 220 212" width="220" height="212" tabindex="0"
    role="application" aria-label="Style blend: drag, or use the arrow keys"><polygon points="${jl.map(d=>d.join()).join(" ")}"
    fill="#f7f6f3" stroke="#cfc8bb" stroke-width="2" stroke-linejoin="round"/>
    ${jl.map(([d,u],f)=>`<line x1="${d}" y1="${u}" x2="110" y2="123.3" stroke="#e4dfd5"/><circle cx="${d}" cy="${u}" r="6"
    fill="${MM[f]}"/><text x="${n[f][0]}" y="${n[f][1]}" text-anchor="${e[f]}"></text>`).join("")}
    <circle class="marker" r="9" fill="#2b323b" stroke="#fff" stroke-width="3"/></svg></div>`;let s=t.querySelector("svg"),r=t.querySelector(".marker"),o=[...t.querySelectorAll("text")],a=[110,123];function l(){let d=i.get("weights");a=[0,1].map(f=>d.reduce((m,v,p)=>m+v*jl[p][f],0)),r.setAttribute("cx",a[0]),r.setAttribute("cy",a[1]);let u=i.get("names");u.forEach((f,m)=>o[m].textContent=`${f}  ${Math.round(100*d[m])} %`),o[2].setAttribute("y",n[2][1]+14*(u[1].length+u[2].length>19))}function c(d){i.set("weights",bM(d)),i.save_changes(),l()}function h(d){let u=new DOMPoint(d.clientX,d.clientY).matrixTransform(s.getScreenCTM().inverse());c([u.x,u.y])}return s.addEventListener("pointerdown",d=>{s.setPointerCapture(d.pointerId),h(d)}),s.addEventListener("pointermove",d=>s.hasPointerCapture(d.pointerId)&&h(d)),s.addEventListener("keydown",d=>{let u={ArrowLeft:[-6,0],ArrowRight:[6,0],ArrowUp:[0,-6],ArrowDown:[0,6]}[d.key];u&&(d.preventDefault(),d.stopPropagation(),c([a[0]+u[0],a[1]+u[1]]))}),i.on("change:weights",l),i.on("change:names",l),l(),()=>{i.off("change:weights",l),i.off("change:names",l)}}var Up={render:wM};var Op={type:"change"},mu={type:"start"},Bp={type:"end"},Ql=new Zs,Fp=new Mn,EM=Math.cos(70*Gh.DEG2RAD),Be=new q,gn=2*Math.PI,fe={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},pu=1e-6,tc=class extends _o{constructor(t,e=null){super(t,e),this.state=fe.NONE,this.target=new q,this.cursor=new q,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:zi.ROTATE,MIDDLE:zi.DOLLY,RIGHT:zi.PAN},this.touches={ONE:Gi.ROTATE,TWO:Gi.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new q,this._lastQuaternion=new Sn,this._lastTargetPosition=new q,this._quat=new Sn().setFromUnitVectors(t.up,new q(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new er,this._sphericalDelta=new er,this._scale=1,this._panOffset=new q,this._rotateStart=new bt,this._rotateEnd=new bt,this._rotateDelta=new bt,this._panStart=new bt,this._panEnd=new bt,this._panDelta=new bt,this._dollyStart=new bt,this._dollyEnd=new bt,this._dollyDelta=new bt,this._dollyDirection=new q,this._mouse=new bt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=TM.bind(this),this._onPointerDown=AM.bind(this),this._onPointerUp=RM.bind(this),this._onContextMenu=UM.bind(this),this._onMouseWheel=IM.bind(this),this._onKeyDown=LM.bind(this),this._onTouchStart=DM.bind(this),this._onTouchMove=NM.bind(this),this._onMouseDown=CM.bind(this),this._onMouseMove=PM.bind(this),this._interceptControlDown=OM.bind(this),this._interceptControlUp=FM.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=fe.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Op),this.update(),this.state=fe.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Be.copy(e).sub(this.target),Be.applyQuaternion(this._quat),this._spherical.setFromVector3(Be),this.autoRotate&&this.state===fe.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=gn:n>Math.PI&&(n-=gn),s<-Math.PI?s+=gn:s>Math.PI&&(s-=gn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Be.setFromSpherical(this._spherical),Be.applyQuaternion(this._quatInverse),e.copy(this.target).add(Be),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Be.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new q(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new q(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Be.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Ql.origin.copy(this.object.position),Ql.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Ql.direction))<EM?this.object.lookAt(this.target):(Fp.setFromNormalAndCoplanarPoint(this.object.up,this.target),Ql.intersectPlane(Fp,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>pu||8*(1-this._lastQuaternion.dot(this.object.quaternion))>pu||this._lastTargetPosition.distanceToSquared(this.target)>pu?(this.dispatchEvent(Op),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?gn/60*this.autoRotateSpeed*t:gn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Be.setFromMatrixColumn(e,0),Be.multiplyScalar(-t),this._panOffset.add(Be)}_panUp(t,e){this.screenSpacePanning===!0?Be.setFromMatrixColumn(e,1):(Be.setFromMatrixColumn(e,0),Be.crossVectors(this.object.up,Be)),Be.multiplyScalar(t),this._panOffset.add(Be)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Be.copy(s).sub(this.target);let r=Be.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(gn*this._rotateDelta.x/e.clientHeight),this._rotateUp(gn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(gn*this._rotateDelta.x/e.clientHeight),this._rotateUp(gn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new bt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function AM(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function TM(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function RM(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Bp),this.state=fe.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function CM(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case zi.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=fe.DOLLY;break;case zi.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=fe.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=fe.ROTATE}break;case zi.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=fe.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=fe.PAN}break;default:this.state=fe.NONE}this.state!==fe.NONE&&this.dispatchEvent(mu)}function PM(i){switch(this.state){case fe.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case fe.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case fe.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function IM(i){this.enabled===!1||this.enableZoom===!1||this.state!==fe.NONE||(i.preventDefault(),this.dispatchEvent(mu),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Bp))}function LM(i){this.enabled!==!1&&this._handleKeyDown(i)}function DM(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case Gi.ROTATE:if(this.enableRotate===!1){this.state=fe.NONE;break}this._handleTouchStartRotate(i),this.state=fe.TOUCH_ROTATE;break;case Gi.PAN:if(this.enablePan===!1){this.state=fe.NONE;break}this._handleTouchStartPan(i),this.state=fe.TOUCH_PAN;break;default:this.state=fe.NONE}break;case 2:switch(this.touches.TWO){case Gi.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=fe.TOUCH_DOLLY_PAN;break;case Gi.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=fe.TOUCH_DOLLY_ROTATE;break;default:this.state=fe.NONE}break;default:this.state=fe.NONE}this.state!==fe.NONE&&this.dispatchEvent(mu)}function NM(i){switch(this._trackPointer(i),this.state){case fe.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case fe.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case fe.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case fe.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=fe.NONE}}function UM(i){this.enabled!==!1&&i.preventDefault()}function OM(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function FM(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var ec=i=>`vec3(${i.map(t=>t.toFixed(4)).join(", ")})`,kp=`
uniform highp sampler2D poses;
uniform vec3 lamp;
in vec4 hosts, shares;
vec4 row(int i, int number) {
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 4; k++)
    if (shares[k] > 0.0) sum += shares[k] * texelFetch(poses, ivec2(3 * int(hosts[k]) + number, i), 0);
  return sum;
}
`,BM=`${kp}
in vec3 tone, trunk, tint;
out vec3 lit;
void main() {
  vec4 a = row(gl_InstanceID, 0), b = row(gl_InstanceID, 1), c = row(gl_InstanceID, 2), at = vec4(position, 1.0);
  vec3 n = normalize(vec3(dot(a.xyz, normal), dot(b.xyz, normal), dot(c.xyz, normal)));
  vec3 light = ${ec(Io)} + (0.5 + 0.5 * n.y) * (${ec(ru)} - ${ec(Io)}) + max(dot(n, lamp), 0.0) * ${ec(su)};
  lit = pow(min((tone + trunk * tint) * light, 1.0), vec3(1.0 / 2.2));
  gl_Position = projectionMatrix * viewMatrix * vec4(dot(a, at), dot(b, at), dot(c, at), 1.0);
}`,kM=`${kp}
void main() {
  vec4 at = vec4(position, 1.0);
  vec3 p = vec3(dot(row(gl_InstanceID, 0), at), dot(row(gl_InstanceID, 1), at), dot(row(gl_InstanceID, 2), at));
  p -= p.y / lamp.y * lamp;
  gl_Position = projectionMatrix * viewMatrix * vec4(p.x, 0.003, p.z, 1.0);
}`,zM="in vec3 lit; out vec4 color; void main() { color = vec4(lit, 1.0); }",GM="uniform vec3 shade; out vec4 color; void main() { color = vec4(shade, 1.0); }",pr=class{constructor(t,e,n,s){let r=Lo(t.mesh),{points:o,normals:a,tones:l,triangles:c,hosts:h,shares:d,inverse:u}=r,f=e.length;Object.assign(this,{inverse:u,tree:new Vn(t),size:u.length}),this.poses=new as(new Float32Array(this.size*f),this.size/4,f,An,mn);let m=Float32Array.from(o,(x,b)=>ou(r,Math.floor(b/3))),v=Float32Array.from(e.flat());this.geometry=new go().setIndex(new Ue(c,1)),this.geometry.instanceCount=f;let p=(x,b,M)=>this.geometry.setAttribute(x,new Ue(b,M));p("position",o,3),p("normal",a,3),p("tone",l,3),p("trunk",m,3),p("shares",d,4),p("hosts",Float32Array.from(h),4),this.geometry.setAttribute("tint",new ls(v,3));let g={poses:{value:this.poses},lamp:{value:n.clone().normalize()},shade:{value:new q(...[1,3,5].map(x=>parseInt(s.slice(x,x+2),16)/255))}};this.meshes=[[BM,zM,Jn],[kM,GM,Ie]].map(([x,b,M])=>{let E=new In({vertexShader:x,fragmentShader:b,side:M,uniforms:g,glslVersion:Eo}),S=new we(this.geometry,E);return S.frustumCulled=!1,S})}pose(t){t.forEach(([e,n],s)=>{this.tree.pose(e,n),this.tree.transforms(this.inverse,this.poses.image.data.subarray(this.size*s,this.size*(s+1)))}),this.poses.needsUpdate=!0}dispose(){this.geometry.dispose(),this.poses.dispose();for(let{material:t}of this.meshes)t.dispose()}},nc=class{constructor(t,e,n,s){this.bodies=e.map(r=>new Vi(t,n,!0,r)),this.meshes=this.bodies.flatMap(r=>[r.mesh,r.shadow(s)])}pose(t){t.forEach((e,n)=>this.bodies[n].pose(...e))}dispose(){for(let t of this.bodies)t.dispose()}};var zp=({places:i},[t,e])=>[0,1,2].map(n=>(i[3*t+n]+i[3*e+n])/2),ic=class extends Vi{constructor(t,e,n){super(t,e,n);let{mesh:s}=t,{follow:r}=s;this.mesh.material.side=Ie,Object.assign(this,{follow:r,scale:r?.scale??1,own:new Vn(s)}),this.rest=r&&Float32Array.from(r.rest.flat())}pose(t,e){this.tree.pose(t,e),this.follow&&this.lead(),this.skin(this.follow?this.own:this.tree)}lead(){let{rules:t,scale:e,lift:n,hips:s}=this.follow,{own:r,tree:o,rest:a}=this,l=new Float32Array(8),c=new Map(t.map(u=>[u[0],u]));r.parents.forEach((u,f)=>{let m=c.get(f);if(!m){u<0?r.turned.set(a.subarray(4*f,4*f+4),4*f):lr(r.turned,4*u,a,4*f,r.turned,4*f);return}lr(o.turned,4*m[1],m,4,l,0),lr(o.turned,4*m[2],m,8,l,4);let v=l[0]*l[4]+l[1]*l[5]+l[2]*l[6]+l[3]*l[7],p=m[3],g=Math.acos(Math.min(Math.abs(v),1)),x=Math.sin(g),b=v<0?-1:1,[M,E]=x<1e-4?[1-p,p]:[Math.sin((1-p)*g)/x,Math.sin(p*g)/x],S=[0,1,2,3].map(y=>M*l[y]+b*E*l[4+y]),_=Math.hypot(...S);lr(S.map(y=>y/_),0,m,12,r.turned,4*f)}),r.put([0,0,0]);let h=zp(r,s[1]),d=zp(o,s[0]);r.put(d.map((u,f)=>e*u+(f===1?n:0)-h[f]))}};var Gp="#f3f1ec",HM="#eae6de",VM="#d8d3c8",Hp="#cdc8be",gu={back:"#efece6",line:"#cbc5b9"};function WM(){let i=document.createElement("canvas").getContext("webgl2"),t=i?.getExtension("WEBGL_debug_renderer_info"),e=t?String(i.getParameter(t.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|softpipe|software|basic render/i.test(e)}var vi;function XM(i){let t=document.createElement("canvas");t.width=t.height=256;let e=t.getContext("2d");e.fillStyle=HM,e.fillRect(0,0,256,256),e.strokeStyle=VM,e.lineWidth=5,e.strokeRect(0,0,256,256),e.lineWidth=1.5,e.beginPath(),e.moveTo(128,0),e.lineTo(128,256),e.moveTo(0,128),e.lineTo(256,128),e.stroke();let n=new Yr(t);return n.colorSpace=on,n.wrapS=n.wrapT=Vs,n.repeat.set(60,60),n.anisotropy=i,n}function qM(i=13,t=.03){let e=[],n=[],s=[],r=new Yt(gu.line),o=new Yt(gu.back);for(let l=1-i;l<i;l++)for(let c=-i;c<i;c+=2)for(let[h,d,u,f]of[[l,c+1,t,2],[c+1,l,2,t]]){if(Math.hypot(h,d)>i)continue;let m=e.length/3;s.push(m,m+1,m+2,m,m+2,m+3);for(let[v,p]of[[-1,-1],[1,-1],[1,1],[-1,1]]){let g=[h+v*u/2,d+p*f/2,0],x=Math.min(Math.hypot(...g)/i,1);e.push(...g),r.clone().lerp(o,x**.7).toArray(n,n.length)}}let a=new $e().setIndex(s);return a.setAttribute("position",new Te(e,3)),a.setAttribute("color",new Te(n,3)),new we(a,new hn({vertexColors:!0,fog:!1}))}function Vp(i,t,e,n,s){let r=i.length/3,o=new Float32Array(r*6),a=[],l=[t/2,0];for(let u=0;u<r;u++){let f=3*Math.max(u-1,0),m=3*Math.min(u+1,r-1),v=i[m]-i[f],p=i[m+2]-i[f+2],g=Math.hypot(v,p);g>1e-4&&(l=[p/g*(t/2),-v/g*(t/2)]),o.set([i[3*u]+l[0],e,i[3*u+2]+l[1],i[3*u]-l[0],e,i[3*u+2]-l[1]],6*u),u&&a.push(2*u-2,2*u,2*u-1,2*u-1,2*u,2*u+1)}let c=new $e;c.setAttribute("position",new Ue(o,3)),c.setIndex(a);let h=new hn({color:n,opacity:s,transparent:!0,side:Ie,depthWrite:!1}),d=new we(c,h);return d.frustumCulled=!1,d}var ei=class{constructor(t,e,{facing:n=0,distance:s=3.6,height:r=.95}={}){this.element=t,this.skeleton=e,vi??=WM();let o=document.createElement("canvas"),a=o.getContext("webgl2",{alpha:!1,antialias:!vi,powerPreference:"high-performance"});this.renderer=new Wl({canvas:o,context:a}),vi&&(re.enabled=!1,this.renderer.outputColorSpace=os),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=hs,this.canvas=this.renderer.domElement,t.append(this.canvas),this.scene=new Vr,this.scene.background=new Yt(vi?gu.back:Gp),this.scene.fog=new Hr(Gp,7,19),this.scene.add(new uo(16777215,14209995,2.25)),this.light=new q(2.7*Math.sin(n-.15),5.2,2.7*Math.cos(n-.15)),this.sun=new mo(16775922,1.5),this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.radius=3,this.sun.shadow.bias=-4e-4,this.sun.shadow.normalBias=.03,Object.assign(this.sun.shadow.camera,{left:-1.8,right:1.8,top:1.8,bottom:-1.8,near:1,far:12}),this.scene.add(this.sun,this.sun.target);let l=vi?null:XM(this.renderer.capabilities.getMaxAnisotropy());this.floor=vi?qM():new we(new Oi(60,60),new hn({map:l})),this.floor.rotation.x=-Math.PI/2,this.shade=new we(new Oi(6,6),new ao({opacity:.22,depthWrite:!1})),this.shade.position.z=.001,this.shade.receiveShadow=!0,this.floor.add(this.shade),this.scene.add(this.floor),this.bodies=[],this.body=this.add(),this.camera=new an(36,1,.1,60),this.controls=new tc(this.camera,this.canvas),Object.assign(this.controls,{enablePan:!1,minDistance:1.2,maxDistance:12,maxPolarAngle:1.55,enableDamping:!0,dampingFactor:.15}),this.facing=n,this.controls.target.set(0,r,0);let c=n-.9;this.camera.position.set(Math.sin(c)*s,r+.55,Math.cos(c)*s),this.still=!1,this.setQuality(vi?2:0),this.observer=new ResizeObserver(()=>{this.resize(),this.render(this)}),this.observer.observe(t)}add({ghost:t=!1}={}){let{skeleton:e}=this,n=new(e.mesh.own?ic:Vi)(e,this.light,vi);if(this.bodies.push(n),this.scene.add(n.mesh),t){Object.assign(n.mesh.material,{transparent:!0,opacity:.35}),n.mesh.castShadow=!1;let s=new we(n.mesh.geometry,new hn({colorWrite:!1,transparent:!0}));s.frustumCulled=!1,[s.renderOrder,n.mesh.renderOrder]=[1,2],n.mesh.add(s)}else this.scene.add(n.projected=n.shadow(Hp));return this.show(n,!0),n}show(t,e){t.mesh.visible=e,t.projected&&(t.projected.visible=e&&this.quality>=2)}setPose(t,e){this.body.pose(t,e)}setContacts(t){this.body.setContacts(t)}addCrowd(t,e){this.crowd=new(vi?nc:pr)(t,e,this.light,Hp),this.scene.add(...this.crowd.meshes)}setTrail(t){for(let e of this.trail??[])this.scene.remove(e),e.geometry.dispose(),e.material.dispose();this.trail=t&&[Vp(t,.018,.004,"#8d8678",.35),Vp(t,.03,.006,"#7b68c4",.9)],this.trail&&this.scene.add(...this.trail)}setMarks(t){let e=this.marks??=[];for(;e.length<t.length;)e.push(new we(new oo(.035,12,8),new hn({color:"#d03a2b"}))),this.scene.add(e.at(-1));e.forEach((n,s)=>{n.visible=s<t.length,n.visible&&n.position.set(...t[s])})}showTrail(t,e=!0){if(this.trail){for(let n of this.trail)n.visible=e;this.trail[1].geometry.setDrawRange(0,6*Math.max(0,Math.floor(t)))}}follow(t,e,{smooth:n=.12,jump:s=!1,camera:r=!0}={}){let o=this.controls.target,a=s?1:n;if(r){let l=(t-o.x)*a,c=(e-o.z)*a;o.x+=l,o.z+=c,this.camera.position.x+=l,this.camera.position.z+=c}this.floor.position.set(Math.round(o.x),0,Math.round(o.z)),this.sun.target.position.set(t,.6,e),this.sun.position.copy(this.light).add(this.sun.target.position)}lookLike(t){this.camera.position.copy(t.camera.position).sub(t.controls.target).applyAxisAngle(this.camera.up,this.facing-t.facing).add(this.controls.target)}setQuality(t){this.renderer.shadowMap.enabled=this.sun.castShadow=this.shade.visible=t<2,this.quality=t;for(let e of this.bodies)this.show(e,e.mesh.visible);this.resize()}resize(){let{clientWidth:t,clientHeight:e}=this.element;if(!t||!e)return;let n=this.quality>2&&!this.still?.6:1,s=this.still&&this.quality?2:1;this.renderer.setPixelRatio(Math.min(devicePixelRatio,this.quality?1:2)*n*s),this.renderer.setSize(t,e,!0),this.camera.aspect=t/e,this.camera.fov=t<e?Math.min(36*(e/t)**.7,60):36,this.camera.updateProjectionMatrix()}render({still:t=!1}={}){t!==this.still&&(this.still=t,this.resize()),this.controls.update(),this.renderer.render(this.scene,this.camera)}dispose(){this.observer.disconnect(),this.controls.dispose(),this.setTrail(null);for(let t of this.bodies)t.dispose();this.crowd?.dispose(),this.renderer.dispose(),this.renderer.forceContextLoss(),this.canvas.remove()}};var Mi=["#7b68c4","#2fa596","#d6598b","#c9a227","#5b8def","#8a8f98"],$M={right:"#e39a6c",left:"#6a9fcb"},YM=12,ZM=[.1,.25,.5,1,2],JM=`
.tkv{--ink:#2b323b;--soft:#6d7580;--line:#ddd8ce;--paper:#fbfaf7;--accent:#7b68c4;display:flex;flex-direction:column;gap:12px;
 height:100%;min-height:320px;color:var(--ink);font:14px/1.4 system-ui,-apple-system,"Segoe UI",Roboto,sans-serif}
.tkv *{box-sizing:border-box}
.tkv-views{flex:1;min-height:0;display:grid;gap:12px}
.tkv-view{position:relative;min-height:0;overflow:hidden;border-radius:14px;background:#f3f1ec;box-shadow:0 1px 2px #0001,0 6px 24px #0000000f}
.tkv-stage{position:absolute;inset:0;cursor:grab}.tkv-stage:active{cursor:grabbing}.tkv-stage canvas{display:block}
.tkv-label{position:absolute;left:16px;top:12px;font-weight:650;font-size:15px;pointer-events:none}
.tkv-styles{position:absolute;right:14px;top:12px;width:150px;padding:8px 10px;border-radius:12px;background:#fffc;pointer-events:none}
.tkv-styles svg{display:block;width:100%;overflow:visible;margin:0 0 6px}
.tkv-row{display:grid;grid-template-columns:10px 1fr auto;gap:6px;align-items:center;font-size:12px}
.tkv-row i{width:9px;height:9px;border-radius:50%}.tkv-row b{font-weight:600;font-variant-numeric:tabular-nums}
.tkv-row span{overflow:hidden;text-overflow:ellipsis;white-space:nowrap}
.tkv-bar{display:flex;align-items:center;gap:12px;padding:10px 14px;border-radius:14px;background:var(--paper);
 box-shadow:0 1px 2px #0001,0 6px 24px #0000000f;flex-wrap:wrap}
.tkv button,.tkv select{font:inherit;color:inherit;border:1px solid var(--line);background:#fff;border-radius:9px;height:34px;padding:0 10px;cursor:pointer}
.tkv button:hover,.tkv select:hover{border-color:#bdb6a8}
.tkv :focus-visible{outline:2px solid var(--accent);outline-offset:2px}
.tkv .tkv-play{width:42px;height:42px;border-radius:50%;border:0;background:var(--accent);padding:0;display:grid;place-items:center}
.tkv .tkv-play svg{width:18px;height:18px;fill:#fff}
.tkv button[aria-pressed=true]{background:#efecfa;border-color:#c9c0ec;color:#4c3fa0}
.tkv-time{flex:1;min-width:220px;position:relative;cursor:pointer;touch-action:none;border-radius:8px}
.tkv-time canvas{display:block;width:100%;height:46px;border-radius:8px}
.tkv-clock{font-variant-numeric:tabular-nums;color:var(--soft);min-width:96px;text-align:right}
.tkv-none{display:grid;place-items:center;height:100%;padding:24px;text-align:center;color:var(--soft)}
@media(max-width:640px){.tkv-views{grid-template-columns:1fr!important}.tkv-styles{width:118px}}
`,KM='<svg viewBox="0 0 18 18"><path d="M4 2.2v13.6a.8.8 0 0 0 1.2.7l11-6.8a.8.8 0 0 0 0-1.4l-11-6.8a.8.8 0 0 0-1.2.7z"/></svg>',jM='<svg viewBox="0 0 18 18"><rect x="3" y="2" width="4.4" height="14" rx="1.2"/><rect x="10.6" y="2" width="4.4" height="14" rx="1.2"/></svg>';function St(i,t,e,n={}){let s=Object.assign(document.createElement(i),n);return t&&(s.className=t),e?.append(s),s}function Oo(i,t){let e=St("a","",null,{download:i,href:URL.createObjectURL(new Blob([t]))});e.click(),setTimeout(()=>URL.revokeObjectURL(e.href),6e4)}var _u=class{constructor(t,{parents:e}){Object.assign(this,{fps:t.fps,frames:t.frames,joints:t.joints,seconds:t.frames/t.fps}),this.root=Ke(t.root,Float32Array),this.packed=Ke(t.rotations,Int16Array),this.contacts=t.contacts&&Ke(t.contacts,Uint8Array),this.names=t.styles?.names??[],this.weights=t.styles&&Ke(t.styles.weights,Uint8Array),this.rotations=new Float32Array(4*e.length);for(let n=0;n<e.length;n++)this.rotations[4*n]=1;this.place=[0,0,0],this.path=this.steady(Math.round(.35*t.fps))}steady(t){let e=new Float32Array(2*this.frames),n=[0,0],s=r=>3*Math.min(Math.max(r,0),this.frames-1);for(let r=-t;r<=t;r++)n[0]+=this.root[s(r)],n[1]+=this.root[s(r)+2];for(let r=0;r<this.frames;r++){e.set([n[0]/(2*t+1),n[1]/(2*t+1)],2*r);for(let o of[0,1])n[o]+=this.root[s(r+t+1)+2*o]-this.root[s(r-t)+2*o]}return e}frameAt(t){return Math.min(t%this.seconds*this.fps,this.frames-1)}sample(t){let e=Math.min(Math.floor(t),this.frames-1),n=Math.min(e+1,this.frames-1),s=t-e;this.centre=[0,1].map(a=>this.path[2*e+a]*(1-s)+this.path[2*n+a]*s);for(let a=0;a<3;a++)this.place[a]=this.root[3*e+a]*(1-s)+this.root[3*n+a]*s;let r=4*this.joints.length,o=[0,0,0,0];this.joints.forEach((a,l)=>{let c=0;for(let h=0;h<4;h++)o[h]=this.packed[e*r+4*l+h]*(1-s)+this.packed[n*r+4*l+h]*s,c+=o[h]*o[h];for(let h=0;h<4;h++)this.rotations[4*a+h]=o[h]/Math.sqrt(c)})}touches(t){let e=Math.round(t);return{right:!!this.contacts?.[2*e],left:!!this.contacts?.[2*e+1]}}blend(t){let e=this.names.length,n=Math.round(t);return Array.from({length:e},(s,r)=>this.weights[n*e+r]/255)}},xu=class{constructor(t,e){if(this.box=St("div","tkv-styles",t),this.corners=e.map((n,s)=>{let r=2*Math.PI*s/e.length-Math.PI/2;return[50+44*Math.cos(r),48+44*Math.sin(r)]}),e.length>2){let n=this.corners.map(([r,o],a)=>`<circle cx="${r}" cy="${o}" r="5" fill="${Mi[a%Mi.length]}"/>`),s=Math.max(...this.corners.map(r=>r[1]))+6;this.box.innerHTML=`<svg viewBox="0 -2 100 ${s+2}"><polygon points="${this.corners.map(r=>r.join()).join(" ")}" fill="#fff"
        stroke="#cfc8bb" stroke-width="1.5" stroke-linejoin="round"/><polyline fill="none" stroke="#2b323b" stroke-opacity=".25"
        stroke-width="1.5"/>${n.join("")}<circle class="m" r="6" fill="#2b323b" stroke="#fff" stroke-width="2"/></svg>`,this.marker=this.box.querySelector(".m")}this.values=e.map((n,s)=>{let r=St("div","tkv-row",this.box);return St("i","",r).style.background=Mi[s%Mi.length],St("span","",r,{textContent:n,title:n}),St("b","",r)})}show(t){let e=t.reduce((r,o)=>r+o,0)||1,n=0,s=0;t.forEach((r,o)=>{this.values[o].textContent=`${Math.round(100*r/e)} %`,n+=r/e*this.corners[o][0],s+=r/e*this.corners[o][1]}),this.marker?.setAttribute("cx",n),this.marker?.setAttribute("cy",s)}};function QM(i,t,e,n){let s=Math.min(devicePixelRatio,2),r=i.clientWidth*s,o=i.clientHeight*s;if(!r)return;if((i.width!==r||i.height!==o)&&(Object.assign(i,{width:r,height:o}),i.base=null),!i.base){i.base=Object.assign(document.createElement("canvas"),{width:r,height:o});let c=i.base.getContext("2d");c.fillStyle="#efece5",c.fillRect(0,0,r,o);let h=t.names.length,d=t.contacts?.16*o:0,u=o-2*d,f=t.seconds/n*r;for(let m=0;h>1&&m<f;m++){let v=t.blend(t.frameAt(m/r*n)),p=v.reduce((x,b)=>x+b,0)||1,g=0;v.forEach((x,b)=>{c.fillStyle=Mi[b%Mi.length]+"b0",c.fillRect(m,g,1,x/p*u),g+=x/p*u})}for(let m=0;d&&m<f;m++){let v=t.touches(t.frameAt(m/r*n));["right","left"].forEach((p,g)=>{c.fillStyle=$M[p],v[p]&&c.fillRect(m,u+g*d+.25*d,1,.6*d)})}}let a=i.getContext("2d");a.drawImage(i.base,0,0);let l=e/n*r;a.fillStyle="#2b323b14",a.fillRect(0,0,l,o),a.fillStyle="#2b323b",a.fillRect(Math.max(0,l-1.25*s),0,2.5*s,o)}function yu(i,{skeletons:t,clips:e,speed:n=1,playing:s=!0,height:r=null}){let o=St("div","tkv",i);St("style","",o,{textContent:JM});let a=St("div","tkv-views",o);r&&(Object.assign(o.style,{height:"auto",minHeight:0}),Object.assign(a.style,{flex:"none",height:`${r}px`}));let l=e.length<4?e.length:Math.ceil(Math.sqrt(e.length));a.style.gridTemplateColumns=`repeat(${l}, minmax(0, 1fr))`;let c;try{c=e.map(({facing:F,skeleton:X})=>{let et=St("div","tkv-view",a),W=new ei(St("div","tkv-stage",et),t[X],{facing:F});return{view:et,scene:W,label:St("div","tkv-label",et)}})}catch(F){return a.innerHTML='<div class="tkv-none">This browser offers no WebGL, which the animation needs.</div>',{error:F}}let h={seconds:0,speed:n,playing:s,trail:!0,feet:!0,follow:!0,drawn:0,fps:0},d=St("div","tkv-bar",o),u=St("button","tkv-play",d,{type:"button"}),f=St("div","tkv-time",d,{tabIndex:0,role:"slider",ariaLabel:"Time"}),m=St("canvas","",f),v=St("div","tkv-clock",d),p=St("select","",d,{title:"Speed",ariaLabel:"Speed"});for(let F of ZM)St("option","",p,{value:F,textContent:`${F}×`,selected:F===n});let g={follow:["Follow","Camera goes along"],trail:["Path","The hips' path on the floor"],feet:["Contacts","Colour the feet that stand"]};for(let[F,[X,et]]of Object.entries(g)){let W=g[F]=St("button","",d,{type:"button",textContent:X,title:et,ariaPressed:"true"});W.onclick=()=>{W.ariaPressed=String(h[F]=!h[F]),A()}}let x,b,M;function E(F){F.forEach((X,et)=>{let W=c[et],U=W.track=new _u(X,t[X.skeleton]);W.label.textContent=X.label,W.styles?.box.remove(),W.styles=U.names.length?new xu(W.view,U.names):null,W.scene.setTrail(U.root)}),x=Math.max(...c.map(({track:X})=>X.seconds)),b=c.find(({track:X})=>X.seconds===x).track,M=c.find(({track:X})=>X.names.length>1)?.track??b,g.feet.hidden=!c.some(({track:X})=>X.contacts),h.seconds%=x,m.base=null}function S(F){for(let{scene:X,track:et,styles:W}of c){let U=et.frameAt(h.seconds);et.sample(U),X.setPose(et.place,et.rotations),X.setContacts(h.feet?et.touches(U):{}),X.showTrail(U,h.trail),X.follow(...et.centre,{jump:!0,camera:h.follow||F}),W?.show(et.blend(U))}}let _=c[0].scene,y=!1,R=0;c.forEach(({scene:F})=>F.controls.addEventListener("change",()=>y=!0)),c.forEach(({scene:F})=>F.canvas.addEventListener("pointerdown",()=>_=F)),c.forEach(({scene:F})=>F.canvas.addEventListener("wheel",()=>_=F,{passive:!0}));function A(F=!1,X=!1){X||(R=0),y=!1,S(F);for(let{scene:et}of c)et!==_&&et.lookLike(_),et.render({still:X});QM(m,M,h.seconds,x),v.textContent=`${h.seconds.toFixed(2)} / ${x.toFixed(2)} s`,f.ariaValueNow=h.seconds.toFixed(2),f.ariaValueMax=x.toFixed(2),h.drawn+=1}function C(F){h.seconds=Math.min(Math.max(F,0),x-1e-6),A()}function N(F=!0){h.playing=F,o.dispatchEvent(new CustomEvent("playing",{detail:F})),u.innerHTML=F?jM:KM,u.ariaLabel=u.title=F?"Pause (space)":"Play (space)"}u.onclick=()=>N(!h.playing),p.onchange=()=>h.speed=Number(p.value);let O=F=>{let X=m.getBoundingClientRect();C(x*(F.clientX-X.left)/X.width)};f.onpointerdown=F=>{f.setPointerCapture(F.pointerId),f.held=h.playing,N(!1),O(F)},f.onpointermove=F=>f.hasPointerCapture(F.pointerId)&&O(F),f.onpointerup=()=>N(f.held),o.addEventListener("keydown",F=>{let X=F.shiftKey?.5:1/b.fps;if(F.key===" "&&F.target.tagName!=="BUTTON")N(!h.playing);else if(F.key==="ArrowRight")C(h.seconds+X);else if(F.key==="ArrowLeft")C(h.seconds-X);else return;F.preventDefault()});let I=performance.now(),k=0,D=0,L=0;function B(F){if(L=requestAnimationFrame(B),!o.isConnected)return;let X=Math.min(Math.max(F-I,0)/1e3,.25);if(I=F,h.playing&&(h.seconds=(h.seconds+X*h.speed)%x,k+=X,++D===40||k>1)){h.fps=D/k;let et=c[0].scene.quality;h.fps<32&&et<3&&c.forEach(({scene:W})=>W.setQuality(et+1)),k=D=0}h.playing||c.forEach(({scene:et})=>et.controls.update()),h.playing||y?A():++R===YM&&A(!1,!0)}function z(){cancelAnimationFrame(L),c.forEach(({scene:F})=>F.dispose()),o.remove()}return E(e),N(s),A(!0),L=requestAnimationFrame(B),{root:o,seek:C,play:N,dispose:z,state:h,get tracks(){return c.map(F=>F.track)},scenes:c.map(F=>F.scene),load:F=>{E(F),A()}}}function Wp({model:i,el:t}){let[e,n]=i.get("size"),s=St("div","",t);Object.assign(s.style,{width:`${e}px`,maxWidth:"100%"}),s.dataset.lmSuppressShortcuts="true";let r=null,o,a;function l(){if(r?.error)return;let h=i.get("clips"),d=h.map(({skeleton:f})=>f).join();if(r&&o===i.get("skeletons")&&a===d)return r.load(h);let u=r?.state.seconds??0;r?.dispose(),[o,a]=[i.get("skeletons"),d],r=yu(s,{skeletons:o,clips:h,playing:i.get("playing"),height:n}),!r.error&&(u&&r.seek(u),r.root.addEventListener("playing",({detail:f})=>{i.set("playing",f),i.save_changes()}),t.toolkit=r)}let c=()=>r.error||r.state.playing===i.get("playing")||r.play(i.get("playing"));return i.on("change:clips",l),i.on("change:playing",c),l(),()=>{i.off("change:clips",l),i.off("change:playing",c),r.dispose?.()}}var Xp={KeyW:"ahead",KeyS:"back",KeyA:"left",KeyD:"right",KeyQ:"turnLeft",KeyE:"turnRight",ArrowUp:"ahead",ArrowDown:"back",ArrowLeft:"turnLeft",ArrowRight:"turnRight",ShiftLeft:"run",ShiftRight:"run"},tS=60,eS=2,sc=12,vu=6,nS=1500,iS=3,sS=12,$p=["left hand","right hand","left foot","right foot"],rS=`
.tkc{display:flex;flex-wrap:wrap;gap:14px;color:#2b323b;font:13px/1.4 system-ui,-apple-system,"Segoe UI",Roboto,sans-serif}
.tkc *{box-sizing:border-box}.tkc [hidden]{display:none}
.tkc-view{position:relative;overflow:hidden;border-radius:12px;background:#f3f1ec;flex:1 1 400px;align-self:flex-start}
.tkc-view:focus-within{outline:2px solid #7b68c4;outline-offset:1px}
.tkc-stage{position:absolute;inset:0;outline:none}.tkc-stage canvas{display:block}
.tkc-hint{position:absolute;left:14px;bottom:12px;color:#6d7580;pointer-events:none}
.tkc-found{color:#a8442a}.tkc-found:empty{display:none}
.tkc-alert{position:absolute;left:50%;top:14px;transform:translateX(-50%);padding:4px 12px;border-radius:9px;background:#2b323bdd;color:#fff}
.tkc-alert:empty{display:none}
.tkc-dials{position:absolute;left:12px;top:12px;display:flex;gap:6px;pointer-events:none;font-size:10px;text-align:center;color:#6d7580}
.tkc-dials svg{display:block;width:46px;height:46px;margin:auto}
.tkc-stick{position:absolute;right:14px;bottom:14px;width:96px;height:96px;border-radius:50%;background:#2b323b14;touch-action:none;cursor:grab}
.tkc-stick i{position:absolute;inset:34%;border-radius:50%;background:#2b323b99}
.tkc-side{display:flex;flex-direction:column;gap:8px;width:220px}
.tkc select,.tkc button{font:inherit;color:inherit;border:1px solid #ddd8ce;background:#fff;border-radius:8px;height:30px;padding:0 8px}
.tkc button{cursor:pointer}.tkc button[aria-pressed=true]{background:#efecfa;border-color:#c9c0ec;color:#4c3fa0}
.tkc .tkc-record[aria-pressed=true]{background:#c0392b;border-color:#c0392b;color:#fff}
.tkc-row{display:flex;flex-wrap:wrap;gap:6px;align-items:center}.tkc-row input{flex:1;min-width:0}
.tkc-menus{display:flex;flex-direction:column;gap:8px}
.tkc-fill{height:100%;flex-wrap:nowrap;user-select:none;-webkit-user-select:none;-webkit-tap-highlight-color:transparent}.tkc-fill .tkc-view{align-self:stretch;flex:1;min-height:0;min-width:0;outline:none}
.tkc-fill .tkc-side{overflow:auto}.tkc-fill .tkc-hint{max-width:calc(100% - 150px)}
@media(max-width:700px) and (orientation:portrait){.tkc-fill{flex-direction:column;gap:8px}.tkc-fill .tkc-view{flex:1 0 46%}
 .tkc-fill .tkc-side{display:grid;width:auto;grid-template:repeat(3,auto) 1fr/minmax(0,220px) minmax(122px,1fr);gap:8px;min-height:0}
 .tkc-fill .tkc-menus{grid-column:1/3;flex-direction:row}.tkc-fill select{flex:1;min-width:0}.tkc-fill .tkc-blend{grid-row:2/5}
 .tkc-fill .tkc-blend *{max-width:100%}.tkc-fill .tkc-blend svg{height:auto}
 .tkc-fill .tkc-row{gap:5px}.tkc-fill .tkc-row input{flex-basis:100%}.tkc-fill .tkc-row button{padding:0 7px}
 .tkc-fill .tkc-stick{width:31vmin;height:31vmin}.tkc-fill .tkc-dials svg{width:38px;height:38px}}
`,qp="W A S D to walk, Q E to turn, Shift to run",oS="Push the stick to walk, drag to look around";function aS(i){let t=new js([[0,.09],[.05,-.05],[0,-.02],[-.05,-.05]].map(([o,a])=>new bt(o,a))),e=new ro(t).rotateX(Math.PI/2),n=new hn({side:Ie}),s=new qr(e,n,sc);s.frustumCulled=!1;for(let o=0;o<sc;o++)s.setColorAt(o,new Yt(o<vu?"#a39b8b":"#7b68c4"));i.add(s);let r=new ge;return{mesh:s,show(o,a){for(let l=0;l<sc;l++){let[c,h,d,u]=o.subarray(4*l,4*l+4);r.makeRotationY(Math.atan2(d,u)).setPosition(a*c,.008,a*h),s.setMatrixAt(l,r)}s.instanceMatrix.needsUpdate=!0}}}function lS(i){let t=St("div","tkc-dials",i),e=$p.map(n=>{let s=St("div","",t);return s.innerHTML=`<svg viewBox="-12 -12 24 24"><circle r="11" fill="#fffc" stroke="#cfc8bb"/><line stroke-width="2.5"
      stroke-linecap="round"/></svg>${n}`,s.querySelector("line")});return{box:t,show(n){e.forEach((s,r)=>{let[o,a]=n.subarray(2*r,2*r+2),l=Math.hypot(o,a),c=Math.min(10,7*l)/(l||1);s.setAttribute("x2",c*o),s.setAttribute("y2",-c*a),s.setAttribute("stroke",`hsl(${Math.atan2(o,a)*180/Math.PI} 62% 45%)`)})}}}function cS(i,t,e,n){let s=new Set,r=e.firstChild,o=[0,0];t.addEventListener("keydown",c=>a(c,!0)),t.addEventListener("keyup",c=>a(c,!1)),t.addEventListener("blur",()=>{s.clear(),n()}),i.addEventListener("pointerdown",()=>i.focus({preventScroll:!0}));function a(c,h){!Xp[c.code]||c.ctrlKey||c.metaKey||c.altKey||/SELECT|INPUT/.test(c.target.tagName)||(h?s.add(c.code):s.delete(c.code),n(),c.preventDefault(),c.stopPropagation())}function l(c){let h=e.getBoundingClientRect(),d=h.width/2,u=(c.clientX-h.left)/d-1,f=1-(c.clientY-h.top)/d,m=1/Math.max(1,Math.hypot(u,f));o=[u*m,f*m],r.style.translate=`${o[0]*.68*d}px ${-o[1]*.68*d}px`}return e.addEventListener("pointerdown",c=>{e.setPointerCapture(c.pointerId),l(c)}),e.addEventListener("pointermove",c=>e.hasPointerCapture(c.pointerId)&&l(c)),e.addEventListener("lostpointercapture",()=>{o=[0,0],r.style.translate=""}),{read(){let c=u=>Number([...s].some(f=>Xp[f]===u)),h={move:[c("right")-c("left"),c("ahead")-c("back")],turn:c("turnLeft")-c("turnRight"),run:!!c("run"),stick:o},d=navigator.getGamepads?.().find(u=>u?.connected);if(d){let[u,f,m]=d.axes.map(v=>Math.abs(v)<.15?0:v);(u||f)&&(h.stick=[u,-f]),h.turn||=-(m??0),h.run||=!!d.buttons[0]?.pressed}return h}}}function Mu({model:i,el:t}){let e=St("div","tkc",t);e.dataset.lmSuppressShortcuts="true",St("style","",e,{textContent:rS});let n=i.get("size"),s=St("div","tkc-view",e);n?Object.assign(s.style,{maxWidth:`${n[0]}px`,aspectRatio:n.join(" / ")}):e.classList.add("tkc-fill");let r=St("div","tkc-stage",s,{tabIndex:0,role:"application",ariaLabel:"Character: W A S D, Q E, Shift"}),o;try{let Mt=i.get("crowd");o=new ei(r,i.get("skeleton"),{facing:0,distance:Mt?7:4.2}),Mt&&o.addCrowd(Mt.skeleton,Mt.tints)}catch{s.textContent="This browser offers no WebGL, which the character needs.";return}o.controls.enableDamping=!1;let a=aS(o.scene),l=lS(s),c=St("div","tkc-hint",s),h=St("div","tkc-found",c);St("div","",c,{textContent:matchMedia("(pointer:coarse)").matches?oS:n?`Click, then ${qp}`:`${qp}; drag to look around`});let d=St("div","tkc-stick",s,{title:"Drag to walk"});St("i","",d);let u=St("div","tkc-alert",s,{role:"status"}),f=cS(r,n?r:window,d,()=>Xt()),m=St("div","tkc-side",e),v=St("div","tkc-menus",m),p=[0,1,2].map(Mt=>{let Tt=St("select","",v,{ariaLabel:`Style ${Mt+1}`});for(let dt of i.get("styles"))St("option","",Tt,{value:dt,textContent:i.get("labels")[dt]});return Tt.onchange=()=>{A("names",i.get("names").map((dt,Rt)=>Rt===Mt?Tt.value:dt)),r.focus({preventScroll:!0})},Tt}),g=Up.render({model:i,el:St("div","tkc-blend",m)}),x=St("label","tkc-row",m,{textContent:"Speed "}),b=St("input","",x,{type:"range",min:.2,max:2.5,step:.05}),M=St("span","",x);b.oninput=()=>A("speed",Number(b.value)),b.onchange=()=>r.focus({preventScroll:!0});let E={phases:!0,trajectory:!0,contacts:!0,chase:!0},S=St("div","tkc-row",m),_=St("div","tkc-row",m),y=[["feet","Foot IK"],["arms","Arm IK"],["recording","● Record"]].map(([Mt,Tt])=>{let dt=St("button",Mt==="recording"?"tkc-record":"",S,{type:"button",textContent:Tt});return dt.onclick=()=>A(Mt,!i.get(Mt)),[Mt,dt]}),R={};for(let[Mt,Tt]of[["phases","Phases"],["trajectory","Trajectory"],["contacts","Contacts"],["chase","Camera behind"]]){let dt=R[Mt]=St("button","",_,{type:"button",textContent:Tt,ariaPressed:"true"});dt.onclick=()=>dt.ariaPressed=String(E[Mt]=!E[Mt])}function A(Mt,Tt){i.set(Mt,Tt),i.save_changes(),C()}function C(){i.get("names").forEach((Mt,Tt)=>p[Tt].value=Mt),b.value=i.get("speed"),M.textContent=`${i.get("speed").toFixed(2)} m/s`;for(let[Mt,Tt]of y)Tt.ariaPressed=String(i.get(Mt))}let N=["names","speed","feet","arms","recording"].map(Mt=>`change:${Mt}`);for(let Mt of N)i.on(Mt,C);C();let O=i.get("skeleton").parents.length,I=new Map,k=[],D={received:0,drawn:0,delays:[],frame:0,looks:0,slowest:0},L=i.get("gate"),B=L?.roles&&Lp(i.get("skeleton"),L),z=null,F=0,X=performance.now(),et=0,W="",U=!0,Q=0,K=performance.now(),at=[];function ot(Mt,[Tt]){if(Mt.kind==="others"&&(at=Tt),Mt.kind!=="frame")return;k.push([new Float32Array(Tt.buffer.slice(Tt.byteOffset,Tt.byteOffset+Tt.byteLength)),Mt.input]),k.length>iS&&k.shift(),X=performance.now();let[dt]=k[k.length-1],{frame:Rt,passed:Vt=[[dt.subarray(0,3),dt.subarray(3,3+4*O)]]}=Mt;Vt.forEach((ct,Lt)=>B?.take(Rt+1-Vt.length+Lt,...ct)),D.received+=1,D.frame=Mt.frame,D.received%15===1&&i.send({kind:"seen",frame:Mt.frame})}function It(){return F=k.length>1?F+1:0,I.size?k.splice(0,k.length-1):F>sS&&(k.shift(),F=0),k.shift()}i.on("msg:custom",ot);function Xt(){let{stick:[Mt,Tt],...dt}=f.read(),Rt=null;if(Mt||Tt){let ct=o.controls.target,Lt=o.camera.position,Ft=Math.hypot(ct.x-Lt.x,ct.z-Lt.z)||1,Qt=(ct.x-Lt.x)/Ft,H=(ct.z-Lt.z)/Ft;Rt=[Qt*Tt-H*Mt,H*Tt+Qt*Mt].map(_e=>Math.round(200*_e)/200)}let Vt=JSON.stringify({...dt,heading:Rt});Vt!==W&&(W=Vt,I.set(++et,performance.now()),i.send({kind:"input",id:et,...dt,heading:Rt}))}function Ct(){let Mt=0,Tt=Ft=>z.subarray(Mt,Mt+=Ft),dt=Tt(3),Rt=Tt(4*O),Vt=Tt(4*sc),ct=Tt(2),Lt=Tt(8);o.setPose(dt,Rt),o.crowd?.pose(at),o.setContacts(E.contacts?{right:ct[0]>.5,left:ct[1]>.5}:{}),a.mesh.visible=E.trajectory,a.show(Vt,o.body.scale),R.phases.hidden=Lt.length<2*$p.length,l.box.hidden=!E.phases||R.phases.hidden,!l.box.hidden&&D.drawn%3===0&&l.show(Lt),o.follow(o.body.scale*dt[0],o.body.scale*dt[2],{jump:U}),E.chase&&Kt(Math.atan2(Vt[4*vu+2],Vt[4*vu+3])),U=!1}function Kt(Mt){let{target:Tt}=o.controls,dt=o.camera.position.clone().sub(Tt),Rt=Mt+Math.PI-Math.atan2(dt.x,dt.z),Vt=Math.atan2(Math.sin(Rt),Math.cos(Rt));o.camera.position.copy(dt.applyAxisAngle(o.camera.up,.02*Vt)).add(Tt)}function Jt(){let Mt=performance.now(),Tt=B?.look(Mt+eS,tS);if(D.slowest=Math.max(D.slowest,performance.now()-Mt),!Tt)return;D.looks+=1;let dt=Dp(Tt);h.textContent!==dt&&(h.textContent=dt,h.title=Tt.map(Rt=>Uo(Rt,L)).join(`
`))}function Ht(Mt){if(Q=requestAnimationFrame(Ht),document.hidden||!s.clientWidth)return;Xt();let Tt=i.get("status")||(Mt-X>nS?"waiting for the kernel …":"");if(u.textContent!==Tt&&(u.textContent=Tt),Jt(),!k.length){z&&!o.still&&Mt-X>300&&o.render({still:!0});return}let[dt,Rt]=It();z=dt,Ct(),o.render(),D.drawn+=1,D.drawn%60===0&&(6e4/(Mt-K)<24&&o.quality<3&&o.setQuality(o.quality+1),K=Mt);for(let[Vt,ct]of I)Vt<=Rt&&(I.delete(Vt),D.delays.push(performance.now()-ct));D.delays.length>500&&D.delays.shift()}return t.toolkit={stats:D,scene:o,get pose(){return z}},i.send({kind:"seen",frame:0}),Q=requestAnimationFrame(Ht),()=>{cancelAnimationFrame(Q),i.send({kind:"closed"}),i.off("msg:custom",ot);for(let Mt of N)i.off(Mt,C);g(),o.dispose()}}var bu=["right","left"],lc=bu.map(i=>`${i}_hand`),ac=bu.map(i=>`${i}_foot`),Ye=[...lc,...ac],qi=[...Ye,"look","pose"],rc=[0,-1,0],Tn=(i,t)=>i.map(e=>e*t),Xi=i=>Math.hypot(...i),cc=(i,t,e)=>Math.min(Math.max(i,t),e),Kp=i=>i*i*i*(i*(6*i-15)+10),jp=([i,,t])=>[i,0,t],xs=i=>i.to??i.at;function hS(i,t,e,{BLEND:n}){let s=[],r=-1/0,o=1;for(let a of i.filter(l=>l[t]!=null).sort((l,c)=>l.at-c.at)){let l=Math.max(a.at-n,r),c=(e-l)/Math.max(a.at-l,1e-6),h=Kp(cc(Math.min(c,(xs(a)+n-e)/n),0,1));s.push([a,h]),r=xs(a),o*=1-h}return[s,1-o]}var Yp=({course:{curve:i},heading:t},e)=>{let n=t.angle(e,i.point(e));return[Math.sin(n),Math.cos(n)]};function Qp(i,t,e,n,s){let{curve:r}=e.course,o=Object.fromEntries(n.timed.map(([c,h])=>[c,h])),a=[],l=0;for(let[c,h]of[...i.entries()].sort(([,d],[,u])=>d.at-u.at)){let d=Ye.filter(D=>h[D]!=null),u=`pins[${c}]`;if(!d.length)continue;let f=D=>d.reduce((L,B)=>L+D(B),0)/d.length,m=[0,2].map(D=>f(L=>h[L][D])),v=f(D=>D.startsWith("left")?1:-1),p=!d.some(D=>lc.includes(D)),[g,x]=p?[s.STEP,s.BESIDE*v]:[s.AHEAD,s.ASIDE*v],b=D=>Math.hypot(...r.point(D).map((L,B)=>L-m[B])),M=r.at.filter(D=>D>=l).reduce((D,L)=>D===null||b(L)<b(D)?L:D,null)??l,E=b(M)>s.DETOUR;if(M=Math.max(M-g,l),E||M<s.LEAST)continue;l=M+s.LEAST;let[S,_]=r.point(M),[y,R]=Yp(e,M),A=(m[0]-S)*R-(m[1]-_)*y,C=(m[0]-S)*y+(m[1]-_)*R,N=Math.hypot(C,A-s.SHOULDER*v);(p||v*A<s.ACROSS||N<s.CLOSE||N>s.NEAR)&&(u in o&&([y,R]=Yp(n,o[u])),S=m[0]-g*y-x*R,_=m[1]-g*R+x*y);let O=[...t,...a.map(([,{point:D}])=>D)];for(;O.some(D=>Math.hypot(D.x-S,D.z-_)<s.LEAST);)S+=s.LEAST*y,_+=s.LEAST*R;let I=p?s.BLEND+s.SETTLE:0,k=xs(h)-h.at+2*I;a.push([M,{name:u,point:{x:S,z:_,time:Math.max(h.at-I,1/s.FPS)},pause:k>s.PASSED?k:0}])}return t.flatMap((c,h)=>[{name:`path[${h}]`,point:c,pause:0},...a.filter(([d])=>r.knots[h]<=d&&d<(r.knots[h+1]??1/0)).map(([,d])=>d)])}function oc(i,t){let e=Xi(i),n=e/t-.9;return n>0?Tn(i,t*(1-.1*Math.exp(-10*n))/e):i}var mr=i=>{let t=Xi(i),e=Math.sin(t/2)/Math.max(t,1e-9);return[Math.cos(t/2),...Tn(i,e)]},Su=(i,t)=>{let e=rn(i,t),n=Xi(e);return Tn(e,Math.atan2(n,ji(i,t))/Math.max(n,1e-9))};function Zp(i,t,e,n){let s=ue(i),r=ue(t),o=ue(se(se(s,r),e,1/3)),[a,l]=[[s,o],[o,r]].map(([c,h])=>fn(mr(Tn(Su(c,h),n)),c));return fn(mr(Tn(Su(a,l),n)),a)}function uS(i,t,{LOOK:e,BEHIND:n}){let s=Su(i,t),r=cc((Math.PI-Xi(s))/n,0,1);return Tn(oc(s,e),r*r*(3-2*r))}function dS(i,t,e){let n=i.reduce((c,h,d)=>c+h*t[d],0),s=n<0?Tn(t,-1):t,r=Math.abs(n)>1-1e-7,o=Math.acos(r?0:Math.abs(n)),[a,l]=r?[1-e,e]:[Math.sin((1-e)*o),Math.sin(e*o)].map(c=>c/Math.sin(o));return ue(i.map((c,h)=>a*c+l*s[h]))}function Jp(i,[t,e,n],{REACH:s,FOLD:r,SMOOTH:o}){let a=Math.max(Xi(i),1e-6),l=Xi($t(e,t))+Xi($t(n,e)),c=h=>h>o?h:Math.max(h+o,0)**2/(4*o);return[c(a-s*l)-c(r*l-a),a]}function fS(i,t,e,{spine:n,arms:s},r){let o=[0,0,0],a=[0,0,0],l=0,c=n.slice(1).map((u,f)=>$t(i[u],i[n[f]])),h=u=>oc([u,0,0],r.SINK)[0],d=()=>se(a,rc,l+ji(a,a));for(let u=0;u<r.ROUNDS;u++)bu.forEach((f,m)=>{let v=t[ac[m]],p=e.legs[m].slice(0,3).map(N=>i[N]);l=h(l+v.weight*Math.max(Jp($t($t(v.goal,p[0]),d()),p,r)[0],0));let{goal:g,weight:x}=t[lc[m]],b=s[m].map(N=>i[N]),M=se(i[n[0]],d()),E=c.reduce((N,O,I)=>se(N,fn(mr(Tn(o,(I+1)/n.length)),O)),M),S=se(E,fn(mr(o),$t(b[0],i[n.at(-1)]))),_=$t(g,S),[y,R]=Jp(_,b,r),A=Tn(_,x*y/R),C=$t(S,M);o=oc(se(o,rn(C,A),.7/ji(C,C)),r.LEAN),a=oc(se(a,jp(A),1/4),r.SHIFT),l=h(l+cc((-_[1]-r.LOW)/(r.LOWEST-r.LOW),0,1)*x*Math.max(y,0)/2)});return[o,d()]}function pS(i,t,e,n,{facing:s,names:r}){let o=([v,...p])=>[v,...Tn(p,-1)],a=t.map((v,p)=>p?xn(o(t[n.parents[p]]),v):v),[l,,c]=fn(t[0],s),h=Math.atan2(l,c)/2,d=[Math.cos(h),0,Math.sin(h),0],u=a,f=e[1],m=v=>v.reduce((p,g,x)=>[...p,x?xn(p[n.parents[x]],g):g],[]);for(let[v,p]of i){let g=a.map((b,M)=>v.pose[r[M]]??b),x=[[0,0,0]];x.length=g.length,oi(n,m(g),x),g[0]=xn(d,g[0]),u=u.map((b,M)=>dS(b,g[M],p)),f-=p*(Math.min(...x.map(b=>b[1]))+f)}return[m(u),[e[0],f,e[2]]]}function tm(i,t,e,{shot:{pins:n},course:s},r,o,a,l){let c=e/a.FPS,{curve:h,distance:d}=s,u=B=>h.point(d[Math.min(Le(B*a.FPS),d.length-1)]),f=n.filter(B=>Ye.every(z=>B[z]==null||[B.at,xs(B)].every(F=>Math.hypot(u(F)[0]-B[z][0],u(F)[1]-B[z][2])<=a.FAR))),m=Object.fromEntries(qi.map(B=>[B,hS(f,B,c,a)]));if(qi.every(B=>!m[B][1]))return;let{spine:v,neck:p,arms:g}=o,x=[...i];oi(r,i,t);let b=[...t],M=r.legs.map(([B])=>B),E=B=>B.forEach((z,F)=>i[F]=z),[S,_]=pS(m.pose[0],i,t[0],r,o);E(S),t[0]=_,oi(r,i,t);let y=ue($t(t[M[1]],t[M[0]])),R=rn(rc,y),A={};for(let[B,z]of Ye.entries()){let F=B<2,X=m[z][0].map(([W,U])=>{let Q=cc(c,W.at,xs(W)),K=Kp(Math.min(Math.abs(c-Q)/a.CARRY,1)),[at,ot]=[u(c),u(Q)];return[se(W[z],[at[0]-ot[0],0,at[1]-ot[1]],K),U]}),et=t[F?g[B][2]:r.legs[B-2][2]];for(let[W,U]of X){let Q=F?U:U*U;et=se(et,$t(W,et).map((K,at)=>K*(at===1?U:Q))),F||(et=se(et,rc,-4*a.LIFT*U*(1-U)))}A[z]={goal:et,weight:m[z][1],found:X}}let[C,N]=fS(t,A,r,o,a);ac.forEach((B,z)=>N=se(N,jp($t(t[r.legs[1-z][2]],t[0])),.5*A[B].weight));let O=Object.fromEntries(v.map((B,z)=>[B,(z+1)/v.length])),I=(B,z)=>B===z||B>0&&I(r.parents[B],z);for(let B=0;B<i.length;B++)M.some(z=>I(B,z))?i[B]=x[B]:i[B]=xn(mr(Tn(C,O[B]??=O[r.parents[B]])),i[B]);t[0]=se(t[0],N),oi(r,i,t);let k=p.at(-1),D=fn(i[k],o.facing),L=[0,0,0];for(let[B,z]of m.look[0])L=se(L,$t(uS(D,$t(B.look,t[k]),a),L),z);p.slice(1).forEach((B,z)=>{let F=mr(Tn(L,(z+1)/(p.length-1)));i.forEach((X,et)=>{(et===B||B===k&&I(et,B))&&(i[et]=xn(F,i[et]))})}),lc.forEach((B,z)=>{if(!A[B].weight)return;let[F,X,et]=g[z].map(at=>t[at]),W=Tn(y,z?1:-1),U=$t(X,F),Q=$t(et,X);for(let[at,ot]of A[B].found){let It=se(se(rn(y,ue($t(at,F))),W,.4),se(rc,R),.3),[Xt,Ct]=br(F,X,et,at,null,{soft:a.SOFT},It);U=Zp(U,$t(Xt,F),$t(W,R),ot),Q=Zp(Q,$t(Ct,Xt),$t(W,R),ot)}let K=[Qi($t(X,F),U),Qi($t(et,X),Q)];i.forEach((at,ot)=>{I(ot,g[z][0])&&(i[ot]=xn(K[Number(I(ot,g[z][1]))],i[ot]))})}),l(ac.map((B,z)=>se(b[r.legs[z][3]],$t(A[B].goal,b[r.legs[z][2]]))))}function em({shot:{pins:i},frames:t},e,n,{arms:s},r){return i.flatMap((o,a)=>{let l=Math.max(Le(o.at*r.FPS)-1,0),c=Le(xs(o)*r.FPS)-1;return c<l||c>=t.length?[`pins[${a}] is at ${Number(xs(o).toPrecision(6))} s, after the end of the motion`]:Ye.flatMap((h,d)=>{if(o[h]==null)return[];let u=d<2?s[d]:n.legs[d-2],f=d<2?"shoulder":"hip",m=o[h],v=0;for(let x=l;x<=c;x++)v=Math.max(v,Xi($t(e(x)[u[2]],m)));if(v<=r.MISSED)return[];let p=e(l)[u[0]],g=Math.hypot(m[0]-p[0],m[2]-p[2]);return[`pins[${a}]: the ${h.replace("_"," ")} is ${(100*v).toFixed(0)} cm from its place, which is ${m[1].toFixed(2)} m high and ${g.toFixed(2)} m beside the ${f} of the character at ${Number(o.at.toPrecision(6))} s: it is out of reach`]})})}var $i=1e3,hc=20,nm=256,ys=600,mS=2**31-1,Fo=30,gS=(Math.sqrt(5)-1)/2,_S=["version","shots","apart","walls"],xS={Point:["x","z","time","facing"],StyleKey:["time","blend","easing"],SpeedKey:["time","speed","easing"],Hold:["seconds","time","distance"],Wall:["start","end"],Shot:["path","styles","speeds","holds","smooth","facing","look_at","feet","arms","seed","duration","name","radius","pins"],Pin:["at","to",...qi]};function le(i,t){if(!i)throw new Error(t)}var Bo=i=>i!==null&&typeof i=="object"&&!Array.isArray(i);function _n(i,t,e,n){return le(typeof i=="number"&&i>=e&&i<=n,`${t} must be a number from ${e} to ${n}`),i}var Ln=(i,t)=>i==null?null:t(i);function gr(i,t,e="xz"){let n=e.length===2?"a pair":`${e.length} numbers`;return le(Array.isArray(i)&&i.length===e.length,`${t} must be ${n} (${[...e].join(", ")})`),i.map((s,r)=>_n(s,`${e[r]} of ${t}`,-$i,$i))}function yS(i){let t={at:_n(i.at,"at",0,ys),to:Ln(i.to,e=>_n(e,"to",0,ys))};le(t.to===null||t.to>t.at,"to must be after at"),le(qi.some(e=>i[e]!=null),`a pin needs one of ${qi.join(", ")}`);for(let e of[...Ye,"look"])t[e]=Ln(i[e],n=>gr(n,e,"xyz"));return t.pose=Ln(i.pose,e=>{le(Bo(e),"pose must have four numbers by joint");let n=Object.entries(e).map(([s,r])=>[s,gr(r,`the rotation of ${s}`,"wxyz")]);return le(n.every(([,s])=>Math.abs(Math.hypot(...s)-1)<=.001),"pose: rotations must be quaternions of length 1"),Object.fromEntries(n)}),t}function im(i,t){let[e,n]=gr(i,t);return le(Math.hypot(e,n)>=1e-6,`${t} must not be zero`),[e,n]}function am(i,t){let e=xS[t];if(Array.isArray(i)&&i.length<=e.length)return Object.fromEntries(i.map((n,s)=>[e[s],n]));le(Bo(i),`expected the fields of a ${t}`);for(let n of Object.keys(i))le(e.includes(n),`unknown field ${JSON.stringify(n).slice(0,60)}`);return i}function vs(i,t,e,n){return le(Array.isArray(i),`${t} must be a list`),le(i.length<=nm,`${t}: at most ${nm} entries, got ${i.length}`),i.map((s,r)=>{try{return n(am(s,e))}catch(o){throw new Error(`${t}[${r}]: ${o.message}`)}})}var sm=(i="smooth")=>(le(typeof i=="string"&&Object.hasOwn(hr,i),`easing must be one of ${Object.keys(hr).join(", ")}`),i);function vS(i,t){let e=typeof i=="string"?[{[i]:1}]:Array.isArray(i)?i:[i];le(e.length,"a blend is a style's name or weights of styles");for(let n of e){le(Bo(n)&&Object.keys(n).length,"a blend is a style's name or weights of styles");let s=Object.keys(n);for(let o of s)le(t.includes(o),`unknown style ${JSON.stringify(o).slice(0,60)}`);let r=s.reduce((o,a)=>o+_n(n[a],`the weight of ${a}`,-$i,$i),0);le(Math.abs(r-1)<=1e-4,`the weights of a blend must sum to 1, got ${Number(r.toFixed(6))}`)}return e.length>1?e:e[0]}function wu(i,t){i.forEach((e,n)=>le(!n||e.time>i[n-1].time,`${t}[${n}]: times must increase`))}function Eu(i,t){let e=am(i,"Shot"),n=h=>_n(h,"time",0,ys),s=vs(e.path??[],"path","Point",h=>({x:_n(h.x,"x",-$i,$i),z:_n(h.z,"z",-$i,$i),time:Ln(h.time,n),facing:Ln(h.facing,d=>im(d,"facing"))})),r=typeof e.styles=="string"?[[0,e.styles]]:e.styles??[],o={path:s,styles:vs(r,"styles","StyleKey",h=>({time:n(h.time),blend:vS(h.blend,t),easing:sm(h.easing)})),speeds:vs(e.speeds??[],"speeds","SpeedKey",h=>({time:n(h.time),speed:_n(h.speed,"speed",0,hc),easing:sm(h.easing)})),holds:vs(e.holds??[],"holds","Hold",h=>(le(h.time==null!=(h.distance==null),"a hold needs either a time or a distance"),{seconds:_n(h.seconds,"seconds",0,ys),time:Ln(h.time,n),distance:Ln(h.distance,d=>_n(d,"distance",0,1e6))})),smooth:e.smooth??!0,facing:Ln(e.facing,h=>im(h,"facing")),look_at:Ln(e.look_at,h=>gr(h,"look_at")),feet:e.feet??!0,arms:e.arms??!0,seed:_n(e.seed??0,"seed",0,mS),name:e.name??"shot",duration:Ln(e.duration,h=>_n(h,"duration",1/60,ys)),radius:Ln(e.radius,h=>_n(h,"radius",.05,5)),pins:vs(e.pins??[],"pins","Pin",yS)};le(s.length>1,`path: two or more points are needed, got ${s.length}`);let a=s.slice(1).map((h,d)=>Math.hypot(h.x-s[d].x,h.z-s[d].z)),l=a.reduce((h,d)=>h+d,0);a.forEach((h,d)=>le(h>=.01,`path[${d+1}]: is less than 1 cm from the point before it`)),le(l<=ys*hc,`path: is ${l.toFixed(0)} m long, a path has at most ${ys*hc} m`),wu(s.slice(1).filter(h=>h.time!==null),"path, points with a time"),le(!s[0].time,"path[0]: the first point has the time 0"),le(s.slice(1).every(h=>h.time!==0),"path: only the first point can have the time 0"),le(o.styles.length,"styles: one or more keys are needed"),wu(o.styles,"styles"),wu(o.speeds,"speeds"),le(new Set(o.styles.map(h=>_r(h.blend).length).filter(h=>h>1)).size<2,"styles: all blends by layer need the same number of layers");for(let h of["smooth","feet","arms"])le(typeof o[h]=="boolean",`${h} must be true or false`);le(!o.facing||!o.look_at,"give either facing or look_at, not both"),le(Number.isInteger(o.seed),"seed must be a whole number");let c=typeof o.name=="string"&&o.name.length<=100&&!/\p{C}/u.test(o.name);return le(c,"name must be a line of up to 100 characters"),o}function ko(i,t){le(Bo(i)&&"version"in i&&"shots"in i,"expected an object with the fields version and shots");for(let r of Object.keys(i))le(_S.includes(r),`unknown field ${JSON.stringify(r).slice(0,60)}`);le(i.version===1,"this page reads version 1 of shots"),le(Array.isArray(i.shots)&&i.shots.length,"shots: one or more are needed");let e=vs(i.walls??[],"walls","Wall",r=>({start:gr(r.start,"start"),end:gr(r.end,"end")}));e.forEach(({start:[r,o],end:[a,l]},c)=>le(Math.hypot(r-a,o-l)>=.01,`walls[${c}]: start and end are less than 1 cm apart`));let n=Ln(i.apart,r=>_n(r,"apart",.1,5));le(n!==null||!e.length,"walls are only avoided by characters who keep apart: give apart, metres");let s=vs(i.shots,"shots","Shot",r=>Eu(r,t));return{shots:s,more:Au(s,n===null?{}:e.length?{apart:n,walls:e}:{apart:n})}}var uc=(i,{apart:t})=>i.radius??t/2;function Au(i,t){return t.apart!==void 0&&i.forEach((e,n)=>i.slice(0,n).forEach((s,r)=>{let[{x:o,z:a},l]=[e.path[0],s.path[0]],c=Math.hypot(o-l.x,a-l.z),h=uc(e,t)+uc(s,t),d=`shots[${r}] and shots[${n}] start ${c.toFixed(2)} m`;le(!(c<h),`${d} from each other, closer than the ${h.toFixed(2)} m that they keep`)})),t}function Tu(i,t={}){let e=n=>Array.isArray(n)?n.map(e):Bo(n)?Object.fromEntries(Object.entries(n).filter(([,s])=>s!==null).map(([s,r])=>[s,e(r)])):n;return{version:1,shots:e(i),...t}}var _r=i=>Array.isArray(i)?i:[i];function zo(i,{styles:t,speeds:e}){let n=_r(i);return n.flatMap(r=>Object.entries(r)).reduce((r,[o,a])=>r+a*e[t.indexOf(o)],0)/n.length}function fc(i,t){let[e,n,s]=ur(i.map(l=>l.time),i.map(l=>l.easing),t),r=i[e].blend,o=i[n].blend;if(!s||Array.isArray(r)||Array.isArray(o))return r;let a=Object.fromEntries(Object.entries(r).map(([l,c])=>[l,(1-s)*c]));for(let[l,c]of Object.entries(o))a[l]=(a[l]??0)+s*c;return a}function MS(i,{styles:t,vectors:e,size:n}){let s=_r(i),r=n/s.length,o=new Float64Array(n);return s.forEach((a,l)=>{for(let[c,h]of Object.entries(a)){let d=n*t.indexOf(c);for(let u=l*r;u<(l+1)*r;u++)o[u]+=h*e[d+u]}}),o}var Ru=(i,t)=>({times:i.map(e=>e.time),easings:i.map(e=>e.easing),values:i.map(t)}),SS=(i,t)=>Ru(i.styles,e=>Math.min(Math.max(zo(e.blend,t),0),hc));function Cu(i,t){let e=rm(i,t,i.path.map((s,r)=>({name:`path[${r}]`,point:s,pause:0}))),n=e;for(let s=0;s<2&&i.pins.length;s++)n=rm(i,t,Qp(i.pins,i.path,e,n,t.pins));return n}function rm(i,t,e){let n=new $l(e.map(({point:h})=>[h.x,h.z]),i.smooth,t.rules),s=SS(i,t),{knots:r}=n,o=i.speeds.length?Ru(i.speeds,h=>h.speed):s,a=e.flatMap(({name:h,point:{time:d}},u)=>u&&d!==null?[[h,r[u],d]]:[]),l=[...i.holds,...e.flatMap(({pause:h},d)=>h?[{time:null,distance:r[d],seconds:h}]:[])];n.knots=r.filter((h,d)=>e[d].name.startsWith("path"));let c=i.path.map(h=>h.facing?Math.atan2(...h.facing):null);return{course:new Yl(n,o,a.map(([,h,d])=>[h,d]),l,i.duration),heading:new Zl(n,i.facing,i.look_at,c),natural:s,timed:a}}function bS(i,t){let e=Math.sin(t),n=Math.cos(t);for(let s=0;t&&s+1<i.length;s+=2){let r=i[s],o=i[s+1];i.set([n*r-e*o,e*r+n*o],s)}}function wS({shot:i,course:t,heading:e},{shot:n,course:s,heading:r}){let{FPS:o,LEAD:a,BEFORE:l,SPACING:c}=t.rules,h=({seed:_,facing:y,look_at:R})=>JSON.stringify([_,y,R]);if(h(i)!==h(n))return 0;let d=(_,y)=>{for(let R=0;R<_;R++)if(!y(R))return R;return 1/0},[u,f]=[t.curve,s.curve],m=(_,y)=>Math.max(_.length,y.length),v=d(m(u.at,f.at),_=>u.x[_]===f.x[_]&&u.z[_]===f.z[_]&&u.at[_]===f.at[_]),p=d(m(u.knots,f.knots),_=>u.knots[_]===f.knots[_]&&e.offsets[_]===r.offsets[_]),g=Math.min(v<1/0?u.at[v-1]??0:v,p<1/0?u.knots[p-1]??0:p),x=d(m(i.styles,n.styles),_=>JSON.stringify(i.styles[_])===JSON.stringify(n.styles[_])),b=x<1/0?i.styles[x-1]?.time??-1:x,M=Le(a*o),E=(_,y)=>_[Math.min(y,_.length-1)],S=_=>E(t.distance,_)===E(s.distance,_)&&E(t.speed,_)===E(s.speed,_);return Math.min(t.distance.length,d(t.distance.length,_=>_/o<=b&&S(_)&&S(_+M)&&E(t.distance,_+M)+l+4*c<g))}var dc=class{constructor(t,e,n,s=0,r=[]){Object.assign(this,{shot:t,...Cu(t,e),character:n,since:s,frames:[],places:[],kept:[]});let{course:o,heading:a}=this,l=o.curve.point(0),c=a.angle(0,l);this.count=o.distance.length-1,this.clock=0,this.styles=Ru(t.styles,h=>MS(h.blend,e)),this.style=new Float64Array(e.size),this.life=new bs(e.data.life.amount,e.data.life.period,t.seed),n.state=Mr(n.first,l,[Math.sin(c),Math.cos(c)]),n.spare=Mr(n.first,l,[Math.sin(c),Math.cos(c)]);for(let{phase:h}of[n.state,n.spare])bS(h,2*Math.PI*(t.seed*gS%1));for(let h of r){let{kept:d}=h,u=Math.min(wS(this,h),h.frames.length,this.count),f=Fo*Math.min(Math.floor(u/Fo),d.length-1);f<=this.frames.length||(Object.assign(this,{frames:h.frames.slice(0,f),places:h.places.slice(0,f),kept:d.slice(0,f/Fo)}),n.state=Ki(d[f/Fo]))}}get place(){return[...this.character.state.history.slice(-4,-2)]}ask(){let{clock:t,styles:{times:e,easings:n,values:s}}=this,r=new Float64Array(this.style.length),[o,a,l]=ur(e,n,t/this.course.rules.FPS);for(let c=0;c<r.length;c++)r[c]=s[o][c]+l*(s[a][c]-s[o][c]);return this.style.set(this.life.at(t,r)),bp(this.course,this.heading,t,this.place)}note(){let{state:t}=this.character,e=t.history.slice(-4);this.frames.push({history:e,joints:new Float32Array(t.joints),...Object.fromEntries(["toes","drop","swivel","contacts"].map(n=>[n,t[n].slice()]))}),this.places.push([e[0],e[1]]),this.count=Math.max(this.count,this.frames.length)}step(){let{character:t,frames:{length:e}}=this;if(e>=this.count)return!1;e%Fo===0&&this.kept.push(Ki(t.state)),this.clock=e;let n=this.ask();return Es([t],[n],[this.style]),this.note(),e+1===this.count&&(this.apart=xr(this)),!0}};function xr({course:{curve:i,distance:t},places:e,apart:n}){return n??e.map(([s,r],o)=>{let[a,l]=i.point(dr(i,[s,r],t[Math.min(o+1,t.length-1)]));return Math.hypot(a-s,l-r)})}function ES({curve:i},t,{REACH:e}){let n=Math.min(Math.max(t,e),Math.max(i.length-e,e)),[s,r]=i.tangent(n-e),[o,a]=i.tangent(n+e);return 2*e/Math.max(Math.abs(Math.atan2(s*a-r*o,s*o+r*a)),.001)}function om({styles:i},t){let[e,n,s]=ur(i.map(o=>o.time),i.map(o=>o.easing),t);return Object.entries(_r(i[s>.5?n:e].blend)[0]).reduce((o,a)=>a[1]>o[1]?a:o)[0]}function lm(i,t){let{course:e,natural:n,timed:s,places:r,shot:o}=i,{curve:a,distance:l,speed:c,rules:{FPS:h}}=e,d=[],u=(l.length-1)/h,f=y=>String(Number(y.toPrecision(6))),m=y=>Math.max(Wi(n,y/h),t.SLOW),v=y=>c[y]/m(y),p=y=>`the speed is ${c[y].toFixed(2)} m/s, ${v(y).toFixed(1)} times that of the style`,g=(y,R,A=0)=>{let C=A;for(let N=A;N<y;N++)R(N,C)&&(C=N);return C};for(let y of e.late)d.push(`${s[y][0]} is too far away to be reached at ${f(s[y][2])} s`);if((e.end===null||e.end>u+1e-9)&&d.push(`the end of the path is not reached in ${f(u)} s: ${(a.length-l.at(-1)).toFixed(1)} m are left`),o.holds.forEach((y,R)=>{y.distance===null||y.distance<=a.length||d.push(`holds[${R}] is after the end of the path, ${a.length.toFixed(2)} m long`)}),!r.length)return d;let x=g(r.length+1,(y,R)=>v(y)>v(R),1);c[x]>t.FASTER*m(x)&&d.push(`at ${(x/h).toFixed(1)} s ${p(x)}: slow down or choose a faster style`);let b=xr(i),M=g(b.length,(y,R)=>b[y]>b[R]),E=b.reduce((y,R)=>y+R,0)/b.length;if(b[M]>t.OFF){let y=N=>ES(e,l[N],t),R=g(M+2,(N,O)=>y(N)<y(O),Math.max(M+1-h,1)),A=c.findIndex((N,O)=>O>=Math.max(M+1-h,1)&&O<=M+1&&N<t.SLOW&&l[O]>0&&l[O]<a.length),C=A>0?`it does not stand still in the pause after ${l[A].toFixed(1)} m; slow down before it, or pause elsewhere`:c[R]**2>t.EASY*y(R)?`the turn after ${l[R].toFixed(1)} m, of radius ${y(R).toFixed(1)} m, is too tight at ${c[R].toFixed(2)} m/s; widen it or slow down there`:`${om(o,M/h)} does not keep to it; choose another style there`;d.push(`at ${((M+1)/h).toFixed(1)} s the character is ${(100*b[M]).toFixed(0)} cm from the path: ${C}`)}else E>t.BESIDE&&d.push(`the character is ${(100*E).toFixed(0)} cm from the path on average`);let S=y=>l[y+1]-dr(a,r[y],l[y+1]),_=r.findIndex((y,R)=>Math.abs(S(R))>t.LAG)+1;_&&d.push(`from ${(_/h).toFixed(1)} s on the character is `+(S(_-1)>0?`behind the plan: ${p(_)}; slow down or leave more time`:`ahead of the plan: ${om(o,_/h)} does not stand or walk as slowly; choose another style there`));for(let[y,R,A]of s){if(!y.startsWith("path")||Le(A*h)>r.length)continue;let[C,N]=AS(a.point(R),A,r,t,h);if(!C&&N<=t.NEAR)continue;let O=C===1/0?"never":`${Math.abs(C).toFixed(1)} s ${C>0?"late":"early"}`;d.push(`${y} is met ${O}: at ${f(A)} s the character is ${(100*N).toFixed(0)} cm away`)}return d}function AS([i,t],e,n,{SECONDS:s,NEAR:r},o){let a=n.map(([d,u])=>Math.hypot(d-i,u-t)),l=d=>Math.max(Le((e+d)*o)-1,0),c=Math.min(...a.slice(l(-s),l(s)+1));if(c<=r)return[0,c];let h=1/0;for(let d=Math.max(Le((e-2)*o),0);d<Math.min(Le((e+2)*o),a.length);d++)a[d]<=r&&Math.abs((d+1)/o-e)<Math.abs(h)&&(h=(d+1)/o-e);return[h,c]}var Rn=(i,t)=>i[0]*t[0]+i[1]*t[1],De=(i,t)=>[i[0]-t[0],i[1]-t[1]],Xn=(i,t)=>[i*t[0],i*t[1]],Si=i=>Math.sqrt(Rn(i,i)),cm=(i,t)=>Xn(Math.min(t/Math.max(Si(i),1e-9),1),i);function TS(i,t,e,{AT_ONCE:n,HORIZON:s}){let r=Math.max(Si(i),1e-6),o=r<e,a=o?n:s,l=De(t,Xn(1/a,i)),c=Math.max(Si(l),1e-9),[h,d]=i;if(o||Rn(l,i)<=-e*c)return{normal:Xn(1/c,l),change:e/a-c};let u=Math.sqrt(Math.max(r**2-e**2,0)),f=h*l[1]-d*l[0]>=0?1:-1,m=Xn(1/r**2,[h*u-f*d*e,f*h*e+d*u]),v=[-f*m[1],f*m[0]];return{normal:v,change:-Rn(t,v)}}function RS(i,t,e,n,{radii:s,rules:{ASIDE:r,CLOSE:o}}){let[a,l]=n[i],c=t.some(u=>{let f=De(e[u],e[i]);return Si(f)<s[i]+s[u]+o&&Rn(f,n[i])>0&&Rn(f,n[u])<0}),[h,d]=c?[Math.cos(r),Math.sin(r)]:[1,0];return[h*a-d*l,d*a+h*l]}function CS(i,t,e,n,s){let{radii:r,walls:o,rules:a}=s,{NEIGHBOURS:l,SIGHT:c,SWEEPS:h,SOFT:d,MARGIN:u,BRAKE:f,ROOM:m}=a,v=t[i],g=t.map((S,_)=>[Si(De(S,v)),_]).filter(([S,_])=>_!==i&&S<c).sort(([S],[_])=>S-_).slice(0,l).map(([,S])=>S),x=!0,b=g.map(S=>{let{normal:_,change:y}=TS(De(t[S],v),De(e[i],e[S]),r[i]+r[S],a);return[_,Rn(_,e[i])+y/2,d]});for(let[S,_]of o){let y=De(_,S),R=Math.min(Math.max(Rn(De(v,S),y)/Rn(y,y),0),1),A=De(S,De(v,Xn(R,y))),C=Math.max(Si(A),1e-6);x&&=C>m,b.push([Xn(-1/C,A),(u-C)/f,0])}let M=x?RS(i,g,t,n,s):[...n[i]],E=b.map(()=>0);for(let S=0;S<h;S++)b.forEach(([_,y,R],A)=>{let C=Math.max((y-Rn(_,M)-R*E[A])/(1+R),-E[A]);E[A]+=C,M[0]+=C*_[0],M[1]+=C*_[1]});return M}function PS(i,t,e,{PASSES:n,SPARE:s,MARGIN:r}){let o=i.map(l=>[...l]),a=(l,c)=>t[l]+t[c]+s;for(let l=0;l<n;l++){for(let[h,d]of e){let u=De(d,h);o.forEach((f,m)=>{let v=Math.min(Math.max(Rn(De(f,h),u)/Rn(u,u),0),1),p=De(De(h,Xn(-v,u)),f),g=Math.max(Si(p),1e-6);o[m]=De(f,Xn(Math.max(r-g,0)/g,p))})}let c=o.flatMap((h,d)=>o.slice(0,d).flatMap((u,f)=>Si(De(h,u))<a(f,d)-s/2?[[f,d]]:[]));if(!c.length)break;for(let[h,d]of c.sort(([u,f],[m,v])=>u-m||f-v)){let u=De(o[d],o[h]),f=Math.max(Si(u),1e-6),m=Xn(Math.max(a(h,d)-f,0)/f/2,u);o[h]=De(o[h],m),o[d]=De(o[d],Xn(-1,m))}}return o}function IS({course:{curve:i,distance:t,speed:e,rules:{FPS:n,LEAD:s}}},r,o,a,{WAIT:l,AHEAD:c}){let h=dr(i,o,t[r]),d=t[r]-h>l;if(e[Math.min(r+Le(s*n),e.length-1)]===0)return{velocity:a,held:d};let u=De(i.point(h+c),o);return{velocity:Xn(Math.max(Rn(u,a),0)/Math.max(Rn(u,u),1e-12),u),held:d}}var pc=class{constructor(t,{walls:e=[],...n},{data:{apart:s},rules:{FPS:r,LONGEST:o}}){let a=Math.max(...t.map(l=>l.count));Object.assign(this,{takes:t,walls:e.map(({start:l,end:c})=>[l,c]),rules:s,frames:0}),this.radii=t.map(({shot:l})=>uc(l,n)),this.most=Math.min(s.WAITS*a,Le(o*r));for(let l of t)Object.assign(l,{count:a,apart:[],together:!0})}step(){let{takes:t,rules:e}=this,n=({clock:f,course:{distance:m}})=>Math.min(f,m.length-1);if(this.frames>=this.most||t.every(f=>f.clock>=f.course.distance.length-1))return!1;let s=t.map(f=>f.ask()),r=t.map(f=>f.place),o=t.map(({character:{state:f}})=>[...f.velocity]),a=t.map((f,m)=>IS(f,n(f),r[m],s[m].velocity,e)),l=a.map(f=>f.held),c=t.map(f=>e.FASTER*Math.max(f.course.speed[n(f)],e.SLOWEST)),h=a.map(({velocity:f},m)=>cm(f,c[m])),d=s.map(({facing:f},m)=>({facing:f,velocity:cm(CS(m,r,o,h,this),c[m])}));t.forEach((f,m)=>f.clock+=l[m]?0:1),Es(t.map(f=>f.character),d,t.map(f=>f.style));let u=t.map(({character:{state:{history:f}}})=>[...f.slice(-4,-2)]);PS(u,this.radii,this.walls,e).forEach((f,m)=>{let{history:v,future:p}=t[m].character.state,g=De(f,u[m]),x=v.length-4;for(let b of[0,1]){v[x+b]+=g[b];for(let M=b;M<p.length;M+=4)p[M]+=g[b]}});for(let f of t)f.note();return this.frames+=1,!0}};var LS=25,DS=4,NS=200,Pu=class{constructor(t,e,n,{frames:s,places:r}={frames:[],places:[]}){Object.assign(this,{shot:t,...Cu(t,e),since:n,frames:s,places:r,apart:[]}),this.count=this.course.distance.length-1}fill(t,e){let n=9+4*e,s=this.count=t.length/n;this.frames=Array.from({length:s},(r,o)=>{let a=(l,c)=>t.subarray(o*n+l,o*n+c);return{history:a(0,4),contacts:a(4,6),root:a(6,9),rotations:a(9,n)}}),this.places=this.frames.map(({history:[r,o]})=>[r,o]),this.apart=xr({...this,apart:null})}step(){return!1}},mc=class{constructor(t,e,n){let{course:s,limits:r,styles:o,speeds:a}=t,l=qn(t.vectors);Object.assign(this,{data:t,rules:s,limits:r,styles:o,speeds:a,vectors:l,size:l.length/o.length,changed:n}),Object.assign(this,{...ko(e,o),takes:[],making:[],past:[],future:[],held:null,stats:{ms:[]}}),this.pins={...t.pins,FPS:s.FPS},this.network=t.network?new ws(t.network):null,this.drawn=this.network&&new ts(t,this.network),this.channel=new MessageChannel,this.channel.port1.onmessage=()=>this.work(),this.selected=0,this.renew([],null)}get shot(){return this.shots[this.selected]}get scene(){return Tu(this.shots,this.more)}change(t){let e=JSON.parse(JSON.stringify(this.shots)),n=(t(e)??e).map(s=>Eu(s,this.styles));this.replace({shots:n,more:Au(n,this.more)})}open(t){this.replace(ko(t,this.styles),[])}replace(t,e=this.shots){let n=JSON.stringify(this.scene);JSON.stringify(Tu(t.shots,t.more))!==n&&(this.put(t,e),this.held===null&&this.keep(n))}begin(){this.held??=JSON.stringify(this.scene)}end(){let{held:t}=this;this.held=null,t!==null&&t!==JSON.stringify(this.scene)&&this.keep(t)}keep(t){this.past.push(t),this.past.length>NS&&this.past.shift(),this.future=[],this.changed("kept")}undo(t=this.past,e=this.future){t.length&&(e.push(JSON.stringify(this.scene)),this.put(ko(JSON.parse(t.pop()),this.styles)),this.changed("kept"))}redo(){this.undo(this.future,this.past)}put({shots:t,more:e},n=this.shots){let s=JSON.stringify(this.more);Object.assign(this,{shots:t,more:e,selected:Math.min(this.selected,t.length-1)}),this.renew(n,s),this.changed("shots")}renew(t,e){let n=u=>JSON.stringify({...u,name:""}),s=t.map(n),r=this.shots.map(n),o=performance.now(),a=[],l=[],{more:c}=this,d=JSON.stringify(c)===e&&(c.apart===void 0||r.join()===s.join());r.forEach((u,f)=>{let m=d?s[f]===u?f:s.indexOf(u):-1;a[f]=t.length?this.takes[m<0?f:m]:void 0;let v=c.apart===void 0?[a[f],t.length&&this.making[f]].filter(p=>p&&!p.together):[];l[f]=m>=0?this.making[m]:this.network?new dc(this.shots[f],this,new ts(this.data,this.network),o,v):new Pu(this.shots[f],this,o,a[f]),m<0&&(this.stats.since=l[f].frames.length)}),Object.assign(this,{takes:a,making:l,findings:null,judging:null}),c.apart===void 0||!this.network?this.together=null:d||(this.together=new pc([...l],c,this)),this.due()}due(){let t=this.making.some(Boolean);this.waits||(t?!this.network:this.findings)||(this.waits=!0,this.channel.port2.postMessage(null))}work(){this.waits=!1;let t=performance.now()+LS,{together:e,making:n}=this,s=e?[[e,[...n.keys()]]]:[this.selected,...n.keys()].map(r=>[n[r],[r]]);for(let[r,o]of s){if(!o.some(l=>this.making[l]))continue;let a=!0;for(;a&&performance.now()<t;)for(let l=0;a&&l<(e?1:DS);l++)a=r.step();if(a)break;this.stats.ms.push(performance.now()-this.making[o[0]].since);for(let l of o)[this.takes[l],this.making[l]]=[this.making[l],null]}n.some(Boolean)||this.judge(t),this.changed("frames"),this.due()}filled({scene:t,takes:e,problem:n}){if(!(this.network||!t||JSON.stringify(ko(t,this.styles))!==JSON.stringify({shots:this.shots,more:this.more}))){if(n)throw new Error(n);this.takes=this.shots.map((s,r)=>this.making[r]??this.takes[r]),this.takes.forEach((s,r)=>s.fill(qn(e[r]),this.data.joints.length)),Object.assign(this,{making:this.takes.map(()=>null),findings:null,judging:null}),this.changed("frames"),this.due()}}judge(t){let{data:{gate:e,skeleton:n},takes:s,rules:{FPS:r},more:o}=this;for(this.judging??=fu(s.map((a,l)=>({count:a.frames.length,pose:c=>this.pose(l,c)})),n,r,e,o.apart);performance.now()<t;){let{done:a,value:l}=this.judging.next();if(a){this.findings=l;break}}}get share(){let t=this.shots.map((n,s)=>this.making[s]??this.takes[s]),e=n=>t.reduce((s,r)=>s+n(r),0);return e(n=>n.frames.length)/Math.max(e(n=>n.count),1)}take(t,e=0){let{making:{[t]:n},takes:{[t]:s}}=this;return n&&(n.frames.length>e||!s)?n:s}pose(t,e){let n=this.take(t,e),s=n?.frames[Math.min(Math.max(e,0),n.frames.length-1)],{drawn:r}=this;if(!s||!r)return s??null;r.state=s;let{data:{figure:o,body:a},pins:l}=this,c=n.frames.indexOf(s)+1,h=(d,u,f)=>(this.drawnAt=[d,u],tm(d,u,c,n,a,o,l,f));return r.pose(n.shot,h),{root:r.root,rotations:r.rotations,contacts:s.contacts}}missedPins(t){let{data:{body:e,figure:n}}=this;return em(this.take(t),s=>this.joints(t,s),e,n,this.pins)}joints(t,e){let{drawn:n,data:{skeleton:s}}=this,r=this.pose(t,e);if(!n){let o=new Vn(s);return r&&o.pose(r.root,r.rotations),s.parents.map((a,l)=>[...o.places.subarray(3*l,3*l+3)])}return oi(this.data.body,...this.drawnAt),this.drawnAt[1]}motion(t){let e=this.making[t]??this.takes[t];if(!this.network&&this.making[t])throw new Error("the kernel has not rendered it yet");for(;(this.together??e).step(););return e.frames.map((n,s)=>{let{root:r,rotations:o}=this.pose(t,s);return[r.slice(),o.slice()]})}dispose(){this.making=[],this.channel.port1.close()}};var US="http://www.w3.org/2000/svg",hm=14,OS=.08,FS=.3,BS=1.15,kS=[1,2,5,10,20,50,100,200],um=(i,t,e)=>Math.min(Math.max(i,t),e),Go=i=>Mi[i%Mi.length];function ke(i,t,e={}){let n=document.createElementNS(US,t);return Se(n,e),i.append(n),n}function Se(i,t){for(let[e,n]of Object.entries(t))i.setAttribute(e,n)}function Dn(i,t,e){for(;i.children.length<e;)ke(i,t);for(;i.children.length>e;)i.lastChild.remove();return[...i.children]}function Iu(i,t){let[e,n]=[i[0],i.at(-1)],s=n[0]-e[0],r=n[1]-e[1],o=Math.hypot(s,r),a=0,l=0;return i.forEach(([c,h],d)=>{let u=o<1e-6?Math.hypot(c-e[0],h-e[1]):Math.abs(s*(h-e[1])-r*(c-e[0]))/o;u>a&&(a=u,l=d)}),a<=t?[e,n]:[...Iu(i.slice(0,l+1),t),...Iu(i.slice(l),t).slice(1)]}function dm(i,t,{select:e,edit:n}){let s=ke(i,"svg",{class:"tkd-map",role:"group","aria-label":"Floor map: z is up, x is to the left"}),r=ke(s,"path",{class:"hollow grid"}),o=ke(s,"path",{class:"hollow axes"}),a=ke(s,"g"),l=["z, m","x, m"].map(W=>Object.assign(ke(s,"text"),{textContent:W})),c=ke(s,"path",{class:"hollow walls"}),h=ke(s,"path",{class:"hollow off"}),d=ke(s,"path",{class:"hollow stroke"}),u=ke(s,"g"),f=ke(s,"g"),m=ke(s,"g"),v=new Map,p=[0,3],g=50,x=!1,b=null,M=null,E=0,S=()=>[s.clientWidth/2,s.clientHeight/2],_=([W,U])=>{let[Q,K]=S();return[Q-(W-p[0])*g,K-(U-p[1])*g]},y=W=>{let U=s.getBoundingClientRect(),[Q,K]=S();return[p[0]-(W.clientX-U.left-Q)/g,p[1]-(W.clientY-U.top-K)/g]},R=W=>W.map((U,Q)=>`${Q?"L":"M"}${_(U).map(K=>K.toFixed(1)).join(" ")}`).join(""),A=({course:{curve:W}})=>W.x.map((U,Q)=>[U,W.z[Q]]),C=W=>Math.round(100*W)/100;function N(){let W=t.shots.flatMap(at=>at.path),U=["x","z"].map(at=>W.map(ot=>ot[at])),Q=U.map(at=>Math.min(...at)),K=U.map(at=>Math.max(...at));p=Q.map((at,ot)=>(at+K[ot])/2),g=um(Math.min(...S().map((at,ot)=>2*at/(BS*(K[ot]-Q[ot])+1))),4,120)}function O(W,[U,Q]){let K=um(g*W,2,400);p=[U+(p[0]-U)*g/K,Q+(p[1]-Q)*g/K],g=K}function I([W,U]){let{course:{curve:Q}}=t.take(t.selected),K=hm/g,at=null;return Q.x.forEach((ot,It)=>{let Xt=Math.hypot(ot-W,Q.z[It]-U);Xt<K&&(K=Xt,at=Q.knots.findLastIndex(Ct=>Ct<=Q.at[It]+1e-9))}),at===null?null:Math.min(at,t.shot.path.length-2)}function k(W){let U=t.shot.path.map(({x:K,z:at})=>L([K,at],W)*g),Q=Math.min(...U);return Q<hm?U.indexOf(Q):void 0}s.addEventListener("pointerdown",W=>{if(W.button)return;s.setPointerCapture(W.pointerId),v.set(W.pointerId,W);let U=y(W),Q=W.target.dataset?.k??k(U),K=W.target.dataset?.who;v.size===2?(E=B(),b=M=null):x?b=[U]:W.target.dataset?.pin!==void 0?(t.begin(),M={pin:Number(W.target.dataset.pin),from:U},e({list:"pins",k:M.pin})):Q===void 0&&K!==void 0?(e(null),t.selected=Number(K)):Q!==void 0||I(U)!==null?(t.begin(),M={k:Number(Q),from:U},Q===void 0&&(M.k=I(U)+1,n(at=>{at[t.selected].path.splice(M.k,0,z(U))})),e({list:"path",k:M.k}),f.children[M.k]?.focus({preventScroll:!0})):(M={pan:U},e(null))}),s.addEventListener("pointermove",W=>{if(!v.has(W.pointerId))return;v.set(W.pointerId,W);let U=y(W);if(v.size===2){let Q=B(),K=[...v.values()].map(y);O(Q/E,[0,1].map(at=>(K[0][at]+K[1][at])/2)),E=Q}else b?b.push(U):M?.pin!==void 0?(X(M.pin,M.from,U),M.from=U):M?.pan?p=p.map((Q,K)=>Q+M.pan[K]-U[K]):M&&L(U,M.from)*g>2&&(F(M.k,U),M.from=[1e9,0]);t.changed("look")});let D=W=>{if(v.delete(W.pointerId)){if(b){let U=Iu(b,OS),Q=b.reduce((K,at,ot)=>ot?K+L(at,b[ot-1]):0,0);b=null,Q>FS&&n(K=>{K[t.selected].path=U.map(z)}),et(!1)}M=null,t.end(),t.changed("look")}};s.addEventListener("lostpointercapture",D),s.addEventListener("wheel",W=>{W.preventDefault(),O(Math.exp(-W.deltaY/500),y(W)),t.changed("look")},{passive:!1}),s.addEventListener("focusin",W=>W.target.dataset.k&&e({list:"path",k:Number(W.target.dataset.k)})),s.addEventListener("keydown",W=>{let U=W.target.dataset?.k,Q=W.shiftKey?.01:.1,K={ArrowLeft:[Q,0],ArrowRight:[-Q,0],ArrowUp:[0,Q],ArrowDown:[0,-Q]}[W.key];if(U===void 0||!K)return;W.preventDefault(),W.stopPropagation();let{x:at,z:ot}=t.shot.path[U];F(U,[at+K[0],ot+K[1]])});let L=([W,U],[Q,K])=>Math.hypot(W-Q,U-K),B=()=>Math.max(L(...[...v.values()].map(W=>[W.clientX,W.clientY])),1),z=([W,U])=>({x:C(W),z:C(U),time:null,facing:null}),F=(W,[U,Q])=>n(K=>{Object.assign(K[t.selected].path[W],{x:C(U),z:C(Q)})}),X=(W,U,Q)=>n(K=>{let at=K[t.selected].pins[W];for(let ot of Ye.concat("look"))at[ot]&&(at[ot]=at[ot].map((It,Xt)=>Xt===1?It:It+Q[Xt/2]-U[Xt/2]))});function et(W=!x){return x=W,s.classList.toggle("drawing",W),t.changed("look"),W}return{svg:s,fit:N,toggle:et,out:_,get drawing(){return x},draw(W,U){let[Q,K]=S(),at=kS.find(dt=>dt*g>18)??500,ot=[],It=dt=>Math.ceil(dt/at)*at;for(let dt=It(p[0]-Q/g);dt<p[0]+Q/g;dt+=at)ot.push(`M${_([dt,0])[0]} 0v${2*K}`);for(let dt=It(p[1]-K/g);dt<p[1]+K/g;dt+=at)ot.push(`M0 ${_([0,dt])[1]}h${2*Q}`);Se(r,{d:ot.join("")});let[Xt,Ct]=_([0,0]);Se(o,{d:`M${Xt} 0v${2*K}M0 ${Ct}h${2*Q}`}),Se(l[0],{x:Xt+5,y:2*K-6}),Se(l[1],{x:5,y:Ct-5});let Kt=t.shots.length;Se(c,{d:(t.more.walls??[]).map(({start:dt,end:Rt})=>R([dt,Rt])).join("")}),Dn(a,"path",2*Kt).forEach((dt,Rt)=>{let Vt=Rt>>1,ct=t.take(Vt),Lt=Rt&1,Ft=Vt===t.selected;Se(dt,{class:`hollow ${Lt?"walked":"plan"}`,d:R(Lt?ct.places:A(ct)),stroke:Go(Vt),opacity:Ft?1:.45})});let Jt=t.take(t.selected),{OFF:Ht}=t.limits,Mt=xr(Jt).flatMap((dt,Rt)=>dt>Ht&&Rt?[R([Jt.places[Rt-1],Jt.places[Rt]])]:[]);Se(h,{d:Mt.join("")}),Dn(u,"path",Kt).forEach((dt,Rt)=>{if(!t.pose(Rt,U))return dt.setAttribute("d","");let{frames:ct}=t.take(Rt),[Lt,Ft,Qt,H]=ct[Math.min(U,ct.length-1)].history,_e=-Math.atan2(Qt,H)*180/Math.PI,ce=`translate(${_([Lt,Ft]).join(" ")})rotate(${_e})`;Se(dt,{d:"M0-11L7 8L0 4L-7 8Z",class:"person",fill:Go(Rt),transform:ce,"data-who":Rt})}),Dn(f,"circle",t.shot.path.length).forEach((dt,Rt)=>{let Vt=t.shot.path[Rt],[ct,Lt]=_([Vt.x,Vt.z]),Ft=W?.list==="path"&&W.k===Rt,Qt=`Point ${Rt+1} of the path at x ${Vt.x}, z ${Vt.z}: arrow keys move it, Delete removes it`,H=Go(t.selected);Se(dt,{cx:ct,cy:Lt,r:Ft?8:6,class:Ft?"on":"",fill:Rt?"#fff":H,stroke:H,tabindex:0,role:"button","data-k":Rt,"aria-label":Qt})});let Tt=t.shot.pins.flatMap((dt,Rt)=>Ye.concat("look").flatMap(Vt=>dt[Vt]?[[Rt,dt[Vt]]]:[]));Dn(m,"path",Tt.length).forEach((dt,Rt)=>{let[Vt,[ct,,Lt]]=Tt[Rt],Ft=W?.list==="pins"&&W.k===Vt;Se(dt,{class:`pin${Ft?" on":""}`,d:"M0 0L-5-10a6 6 0 1 1 10 0Z","data-pin":Vt,transform:`translate(${_([ct,Lt]).join(" ")})`})}),Se(d,{d:b?R(b):""})}}}var zS={SCALAR:1,VEC3:3,VEC4:4,MAT4:16};function fm({names:i,parents:t,offsets:e},n,s,r,o=null){let a=[],l=[],c=[],h=0,d=(R,A,C)=>{let N=R instanceof Float32Array?5126:R instanceof Uint16Array?5123:5125,O=-R.byteLength&3;return l.push({buffer:0,byteOffset:h,byteLength:R.byteLength}),a.push(new Uint8Array(R.buffer,R.byteOffset,R.byteLength),new Uint8Array(O)),h+=R.byteLength+O,c.push({bufferView:l.length-1,componentType:N,count:R.length/zS[A],type:A,...C}),c.length-1},u=Float32Array.from(n,(R,A)=>A/s),f=d(u,"SCALAR",{min:[0],max:[u.at(-1)]}),m=[],v=[],p=(R,A,C,N)=>{v.push({sampler:m.length,target:{node:R,path:A}}),m.push({input:f,output:d(C,N),interpolation:"LINEAR"})};p(0,"translation",Float32Array.from(n.flatMap(([R])=>[...R])),"VEC3");let g=i.map((R,A)=>{let C=new Float32Array(4*n.length);return n.forEach(([,N],O)=>{let[I,k,D,L]=N.subarray(4*A,4*A+4),B=[k,D,L,I],z=O&&B.reduce((F,X,et)=>F+X*C[4*(O-1)+et],0)<0?-1:1;C.set(B.map(F=>z*F),4*O)}),C.some((N,O)=>N!==C[O%4])&&p(A,"rotation",C,"VEC4"),{name:R,translation:A?e[A]:[...n[0][0]],rotation:[...C.subarray(0,4)]}});t.forEach((R,A)=>R>=0&&(g[R].children??=[]).push(A));let x={name:r,nodes:[0]},b={};if(o){let R=new Float32Array(16*i.length);i.forEach((L,B)=>{let z=F=>[0,4,8].map(X=>o.inverse[12*B+X+F]).concat(F===3?1:0);R.set([0,1,2,3].flatMap(z),16*B)});let{points:A,tones:C,shares:N}=o,O=L=>A.filter((B,z)=>z%3===L),I=L=>[0,1,2].map(B=>O(B).reduce((z,F)=>L(z,F))),k={POSITION:d(A,"VEC3",{min:I(Math.min),max:I(Math.max)}),NORMAL:d(GS(o.normals),"VEC3"),COLOR_0:d(C,"VEC3"),JOINTS_0:d(Uint16Array.from(o.hosts),"VEC4"),WEIGHTS_0:d(N,"VEC4")},D=d(Uint32Array.from(o.triangles),"SCALAR");b.meshes=[{primitives:[{attributes:k,indices:D,material:0}]}],b.materials=[{pbrMetallicRoughness:{metallicFactor:0,roughnessFactor:.8}}],b.skins=[{joints:i.map((L,B)=>B),skeleton:0,inverseBindMatrices:d(R,"MAT4")}],x.nodes.push(g.push({name:"Mannequin",mesh:0,skin:0})-1)}let M=new TextEncoder().encode(JSON.stringify({asset:{version:"2.0",generator:"toolkit"},scene:0,scenes:[x],nodes:g,...b,animations:[{name:r,samplers:m,channels:v}],buffers:[{byteLength:h}],bufferViews:l,accessors:c})),E=4*Math.ceil(M.length/4),S=new Uint8Array(28+E+h),_=new DataView(S.buffer);[1179937895,2,S.length,E,1313821514].forEach((R,A)=>_.setUint32(4*A,R,!0)),S.fill(32,20,20+E).set(M,20),_.setUint32(20+E,h,!0),_.setUint32(24+E,5130562,!0);let y=28+E;for(let R of a)S.set(R,y),y+=R.length;return S}function GS(i){let t=new Float32Array(i.length);for(let e=0;e<t.length;e+=3){let n=i.subarray(e,e+3),s=Math.hypot(...n)||1;t.set(n.map(r=>r/s),e)}return t}var HS={in:"out",out:"in"},VS=1,gc=.01,Ne=i=>Math.round(i*1e3)/1e3,Ms=(i,t)=>i&&Ne(Math.max(i+t,0)),pm=({end:i,distance:t,rules:{FPS:e}})=>i??(t.length-1)/e,Lu={styles:(i,t)=>({blend:fc(i,t)}),speeds:(i,t)=>({speed:Wi({times:i.map(e=>e.time),easings:i.map(e=>e.easing),values:i.map(e=>e.speed)},t)})};function mm(i,t,e){let n=l=>l&&t(l).map(Ne),s=l=>l&&e(l).map(c=>Math.round(c*1e6)/1e6),r=l=>l&&(([c,h])=>[c,l[1],h])(n([l[0],l[2]])),o=i.path.map(l=>(([c,h])=>({...l,x:c,z:h,facing:s(l.facing)}))(n([l.x,l.z]))),a=i.pins.map(l=>({...l,...Object.fromEntries([...Ye,"look"].map(c=>[c,r(l[c])]))}));return{...i,path:o,pins:a,facing:s(i.facing),look_at:n(i.look_at)}}function gm(i){if(i.pins.some(h=>h.pose))throw new Error("a shot with a pinned pose cannot be mirrored");let[{x:t,z:e},n]=i.path,s=Math.hypot(n.x-t,n.z-e),r=(n.x-t)/s,o=(n.z-e)/s,a=([h,d])=>[2*(r*h+o*d)*r-h,2*(r*h+o*d)*o-d],l=mm(i,([h,d])=>a([h-t,d-e]).map((u,f)=>u+[t,e][f]),a),c=h=>h.startsWith("left")?h.replace("left","right"):h.replace("right","left");return{...l,pins:l.pins.map(h=>({...h,...Object.fromEntries(Ye.map(d=>[c(d),h[d]]))}))}}function Ho(i,t,e,n){if(!i.length)return[];let s=i.findLast(o=>o.time<=e)??i[0],r=[{...s,...Lu[t](i,e),time:e}];return r.push(...i.filter(o=>o.time>e&&o.time<n)),i.at(-1).time>=n&&r.push({...i.at(-1),...Lu[t](i,n),time:n}),r.map(o=>({...o,time:Ms(o.time,-e)}))}function Du(i,t,e,n=1/0){let{curve:s,distance:r,rules:{FPS:o}}=t,a=p=>Math.min(Math.round(p*o),r.length-1),l=r[a(e)],c=r[a(n)];if(c-l<gc)throw new Error("nothing is walked in this part");let h=p=>(([g,x])=>({x:Ne(g),z:Ne(x),time:null,facing:null}))(s.point(p)),d=(p,g)=>Math.abs(s.knots[p]-g)<gc,u=i.path.length-1,f=i.path.filter((p,g)=>s.knots[g]>l+gc&&s.knots[g]<c-gc),m=[d(0,l)?i.path[0]:h(l),...f,d(u,c)?i.path[u]:h(c)],v=({time:p,distance:g})=>p===null?g>=l&&g<c:p>=e&&p<n;return{...i,path:m.map((p,g)=>({...p,time:g?Ms(p.time,-e):null})),styles:Ho(i.styles,"styles",e,n),speeds:Ho(i.speeds,"speeds",e,n),holds:i.holds.filter(v).map(p=>({...p,time:Ms(p.time,-e),distance:Ms(p.distance,-l)})),pins:i.pins.filter(({at:p})=>p>=e&&p<n).map(p=>({...p,at:Ms(p.at,-e),to:Ms(p.to&&Math.min(p.to,n),-e)})),duration:i.duration&&Ms(Math.min(i.duration,n),-e)}}function _m(i,t){let e=Ne(pm(t)),{length:n}=t.curve,s=h=>h&&Ne(Math.max(e-h,0)),r=h=>Ho(i[h],h,0,e).map((d,u,f)=>({...d,time:Ne(e-d.time),easing:u?HS[f[u-1].easing]??f[u-1].easing:d.easing})).reverse(),o=i.path.at(-1).time===null?null:e,a=i.path.map((h,d)=>({...h,time:d===i.path.length-1?null:d?s(h.time):o})).reverse(),l=i.holds.map(h=>({...h,time:h.time===null?null:Ne(Math.max(e-h.time-h.seconds,0)),distance:h.distance===null?null:Ne(Math.max(n-h.distance,0))})),c=i.pins.filter(({at:h})=>h<e).map(h=>h.to===null?{...h,at:Ne(e-h.at)}:{...h,at:Ne(Math.max(e-h.to,0)),to:Ne(e-h.at)});return{...i,path:a,holds:l,pins:c,styles:r("styles"),speeds:r("speeds")}}function xm(i,t,e,n,s){let{curve:r}=t,o=Ne(pm(t)),[a,l]=r.tangent(r.length),[c,h]=n.curve.tangent(0),d=c*a+h*l,u=h*a-c*l,{x:f,z:m}=e.path[0],{x:v,z:p}=i.path.at(-1),g=([S,_])=>[d*S+u*_,d*_-u*S],x=mm(e,([S,_])=>g([S-f,_-m]).map((y,R)=>y+[v,p][R]),g),b=S=>S.map(_=>({..._,time:Ne(_.time+o)})),M=(S,_,y)=>{let R=Ho(_,S,0,o).filter(C=>C.time<o),A=o-VS;return A>R.at(-1).time&&R.push({..._.at(-1),...Lu[S](_,A),time:Ne(A)}),[...R,...b(Ho(y,S,0,1/0))]},E=({speeds:S,styles:_})=>S.length?S:_.map(y=>({time:y.time,speed:zo(y.blend,s),easing:y.easing}));return{...i,path:[...i.path,...x.path.slice(1).map(S=>({...S,time:S.time&&Ne(S.time+o)}))],styles:M("styles",i.styles,e.styles),speeds:i.speeds.length+e.speeds.length?M("speeds",E(i),E(e)):[],holds:[...i.holds,...e.holds.map(S=>({...S,time:S.time===null?null:Ne(S.time+o),distance:S.distance===null?null:Ne(S.distance+r.length)}))],pins:[...i.pins,...x.pins.map(S=>({...S,at:Ne(S.at+o),to:S.to&&Ne(S.to+o)}))],duration:null}}var _c=14,bi=26,Ss=44,yr=50,WS=20,xc=160,ym=.1,vm=.02,Nu={arrivals:17,ghosts:17,pins:16,styles:bi+Ss-8,speeds:0,holds:bi+Ss+yr+11},XS={pins:"M0 8L-4 0a4.6 4.6 0 1 1 8 0Z",arrivals:"M0 7V-7h8v6h-8",ghosts:"M0-5a4 4 0 1 1 0 8 4 4 0 1 1 0-8M-4 7a4 4 0 0 1 8 0Z",styles:"M0-8L7 0L0 8L-7 0Z",speeds:"M-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0",holds:"M-5-6h4v12h-4ZM1-6h4v12h-4Z"},qS=[.5,1,2,5,10,20,60],$S={pins:"Pin",arrivals:"Arrival",ghosts:"Onion skin",styles:"Style key",speeds:"Speed key",holds:"Pause"},Uu=bi+Ss+yr+WS+4;function Ou({styles:i,shots:t},e){let n=new Set(t.flatMap(s=>s.styles.flatMap(r=>Object.keys(Mm(r.blend)))));return`hsl(${(i.filter(s=>n.has(s)).indexOf(e)*137.5+250)%360} 48% 66%)`}var Mm=i=>_r(i).reduce((t,e,n,s)=>{for(let[r,o]of Object.entries(e))t[r]=(t[r]??0)+o/s.length;return t},{});function Sm(i,t,{select:e,edit:n,seek:s,ghosts:r}){let o=ke(i,"svg",{class:"tkd-time",height:Uu,role:"group","aria-label":"Timeline"}),a=ke(o,"rect",{class:"ruler",x:0,y:0,height:bi,tabindex:0,role:"slider","aria-label":"Time"}),l=L=>ke(o,"path",{class:`hollow ${L}`}),c=(L="")=>ke(o,"g",{class:L}),h=l("grid"),d=c(),u=c(),f=c("names"),m=c(),v=c(),p=l("speed"),g=l("off"),x=l("now"),b=c("broken"),M=ke(o,"g"),E=2,S=10,_=null,y=()=>t.take(t.selected),R=()=>o.clientWidth-2*_c,A=L=>_c+L/S*R(),C=L=>(L-_c)/R()*S,N=L=>bi+Ss+yr-5-L/E*(yr-12),O=L=>Math.round(100*L)/100;function I(L){if(L.time!==null)return L.time;let B=y().course.distance.findIndex(z=>z>=Math.min(L.distance,y().course.curve.length)-1e-6);return(B<0?y().count:B)/t.rules.FPS}function k(){let{shot:L}=t,B=(F,X)=>X.map((et,W)=>({list:F,k:W,time:et}));return[...B("arrivals",L.path.map(F=>F.time)).filter(({k:F,time:X})=>F&&X!==null),...B("ghosts",r),...B("pins",L.pins.map(F=>F.at)),...B("styles",L.styles.map(F=>F.time)),...B("speeds",L.speeds.map(F=>F.time)),...B("holds",L.holds.map(I))]}function D({list:L,k:B},z,F=null){let X=Math.min(Math.max(O(z),0),t.rules.LONGEST);L==="ghosts"?(r[B]=X,t.changed("look")):n(et=>{let{path:W,[L]:U}=et[t.selected],{course:{distance:Q},count:K}=y();if(L==="arrivals")W[B].time=Math.max(X,ym);else if(L==="pins")U[B].to&&=O(U[B].to+X-U[B].at),U[B].at=X;else if(L==="holds"&&U[B].time===null)U[B].distance=Q[Math.min(Math.round(X*t.rules.FPS),K)];else{let at=L!=="holds"&&B?U[B-1].time+vm:0;U[B].time=Math.min(Math.max(X,at),L!=="holds"&&B+1<U.length?U[B+1].time-vm:1/0),L==="speeds"&&F!==null&&(U[B].speed=O(Math.min(Math.max(F,0),20)))}})}return o.addEventListener("pointerdown",L=>{if(L.button)return;o.setPointerCapture(L.pointerId);let{list:B,k:z}=L.target.dataset,F=o.getBoundingClientRect();if(_=B?{list:B,k:Number(z),from:L.clientX,low:L.clientY}:{scrub:!0},!B)return s(C(L.clientX-F.left));t.begin(),e({list:B,k:Number(z)}),L.target.focus({preventScroll:!0})}),o.addEventListener("pointermove",L=>{if(!_)return;let B=o.getBoundingClientRect(),z=L.clientX-B.left,F=L.clientY-B.top;if(_.scrub)return s(C(z));Math.hypot(L.clientX-_.from,L.clientY-_.low)<3||(_.from=-1e9,D(_,C(z),(bi+Ss+yr-5-F)/(yr-12)*E))}),o.addEventListener("lostpointercapture",()=>{_=null,t.end(),t.changed("look")}),o.addEventListener("focusin",({target:{dataset:{list:L,k:B}}})=>L&&e({list:L,k:Number(B)})),o.addEventListener("keydown",L=>{let{list:B,k:z}=L.target.dataset,F=L.shiftKey?1:ym,X={ArrowLeft:-F,ArrowRight:F}[L.key],et={ArrowUp:.05,ArrowDown:-.05}[L.key];if(X===void 0&&(et===void 0||B!=="speeds"))return;if(L.preventDefault(),L.stopPropagation(),!B)return s(t.seconds+X);let{time:W}=k().find(U=>U.list===B&&U.k===Number(z));D({list:B,k:Number(z)},W+(X??0),et===void 0?null:t.shot.speeds[z].speed+et)}),{svg:o,draw(L,B){let{shot:z,rules:{FPS:F},limits:{FASTER:X,SLOW:et}}=t,{course:W,count:U,natural:Q}=y(),K=k();_||(S=Math.max(...t.shots.map((ct,Lt)=>t.take(Lt).count/F),...K.map(ct=>ct.time),1),E=Math.max(1.2*Math.max(...W.speed,...z.speeds.map(ct=>ct.speed)),.5));let at=Math.max(o.clientWidth,1),ot=qS.find(ct=>A(ct)-A(0)>46)??120,It=[];for(let ct=0;ct<=S+1e-9;ct+=ot)It.push(ct);Se(a,{width:at,"aria-valuenow":B.toFixed(2),"aria-valuemin":0,"aria-valuemax":S.toFixed(2)}),Se(h,{d:It.map(ct=>`M${A(ct)} 0V${Uu}`).join("")}),Dn(d,"text",It.length).forEach((ct,Lt)=>{Se(ct,{x:A(It[Lt])+3,y:11}),ct.textContent!==`${It[Lt]} s`&&(ct.textContent=`${It[Lt]} s`)});let Xt=z.styles.map(ct=>ct.time),Ct=z.styles.map(ct=>ct.easing),Kt=Math.min(U/F,S),Jt=z.styles.map(ct=>Mm(ct.blend)),Ht=[...new Set(Jt.flatMap(Object.keys))],Mt=Ht.map(ct=>({times:Xt,easings:Ct,values:Jt.map(Lt=>Lt[ct]??0)})),Tt=new Float64Array(xc+1);Dn(u,"path",Ht.length).forEach((ct,Lt)=>{let Ft=[],Qt=[];for(let H=0;H<=xc;H++){let _e=A(Kt*H/xc).toFixed(1),ce=Math.max(Wi(Mt[Lt],Kt*H/xc),0);Qt.unshift(`${_e} ${(bi+Ss*Math.min(Tt[H],1)).toFixed(1)}`),Tt[H]+=ce,Ft.push(`${_e} ${(bi+Ss*Math.min(Tt[H],1)).toFixed(1)}`)}Se(ct,{d:`M${Ft.join("L")}L${Qt.join("L")}Z`,fill:Ou(t,Ht[Lt])})}),Dn(f,"text",z.styles.length).forEach((ct,Lt)=>{let Ft=A(Xt[Lt]),Qt=(Lt+1<Xt.length?A(Xt[Lt+1]):at-_c)-Ft-14,H=Object.keys(Jt[Lt]).join(" + ");Se(ct,{x:Ft+10,y:Nu.styles+4});let _e=Qt>6.4*H.length?H:H.slice(0,Math.max(Qt/6.4-1,0))+(Qt>12?"…":"");ct.textContent!==_e&&(ct.textContent=_e)});let dt=z.speeds.length?z.speeds.map(ct=>[ct.time,`${ct.speed} m/s`,ct.speed]):[[0,"the natural speed of the styles",Math.max(...W.speed)]];Dn(m,"text",dt.length).forEach((ct,Lt)=>{let[Ft,Qt,H]=dt[Lt],_e=(dt[Lt+1]?A(dt[Lt+1][0]):at)-A(Ft)>60;Se(ct,{x:A(Ft)+8,y:N(H)-4}),ct.textContent=_e?Qt:""});let Rt=ct=>W.speed.map((Lt,Ft)=>ct[Ft]?`${Ft&&ct[Ft-1]?"L":"M"}${A(Ft/F).toFixed(1)} ${N(Lt).toFixed(1)}`:"").join("");Se(p,{d:Rt(W.speed.map(()=>!0))}),Se(g,{d:Rt(W.speed.map((ct,Lt)=>ct>X*Math.max(Wi(Q,Lt/F),et)))}),Dn(v,"rect",z.holds.length).forEach((ct,Lt)=>{let Ft=A(I(z.holds[Lt])),Qt=A(Math.min(I(z.holds[Lt])+z.holds[Lt].seconds,S));Se(ct,{class:"pause",x:Ft,y:Nu.holds-8,width:Math.max(Qt-Ft,2),height:16,rx:4})});let Vt=(t.findings??[]).filter(({characters:ct})=>ct.includes(t.selected));Dn(b,"rect",Vt.length).forEach((ct,Lt)=>{let{start:Ft,end:Qt}=Vt[Lt],H=Uo(Vt[Lt],t.data.gate);Se(ct,{class:"defect",x:A(Ft),y:bi-6,width:Math.max(A(Qt)-A(Ft),3),height:6,"aria-label":H,role:"img"}),ct.textContent!==H&&(ct.replaceChildren(),ke(ct,"title",{}).textContent=H)}),Se(x,{d:`M${A(B)} 0V${Uu}`}),Dn(M,"path",K.length).forEach((ct,Lt)=>{let{list:Ft,k:Qt,time:H}=K[Lt],_e=L?.list===Ft&&L.k===Qt,ce=z[Ft]?.[Qt],pe={styles:()=>`, ${Object.keys(Jt[Qt]).join(" and ")}`,speeds:()=>`, ${ce.speed} m/s`,pins:()=>`, ${qi.filter(Bt=>ce[Bt]).join(" and ").replaceAll("_"," ")}`}[Ft]?.()??"",Z=`${$S[Ft]} ${Qt+1} at ${H.toFixed(2)} s${pe}: arrow keys move it, Delete removes it`;Se(ct,{d:XS[Ft],class:`key ${Ft}${_e?" on":""}`,tabindex:0,role:"button","aria-label":Z,"data-k":Qt,"data-list":Ft,transform:`translate(${A(H)} ${Ft==="speeds"?N(ce.speed):Nu[Ft]})`})})}}}var Fu={path:"Point",styles:"Style key",speeds:"Speed key",holds:"Pause",ghosts:"Onion skin",pins:"Pin"},YS={x:"x, m",z:"z, m",time:"time, s",speed:"speed, m/s",distance:"at, m",seconds:"lasts, s",at:"time, s",to:"until, s"},ZS={path:["x","z","time"],styles:["time"],speeds:["time","speed"],holds:["time","distance","seconds"],pins:["at","to"]},Em=[...Ye,"look"],Bu=i=>Em.filter(t=>i?.[t]),JS={smooth:"smooth path",feet:"foot IK",arms:"arm IK"},yc=["the path","a direction","a point"],bm={type:"number",step:"any"},wm=.02,Re=(i,t,e,n)=>St("button","",i,{type:"button",textContent:t,ariaLabel:e,title:e,onclick:n});function ku(i,t,e){let n=Object.keys(i).filter(r=>r!==t),s=n.reduce((r,o)=>r+i[o],0);for(let r of n)i[r]=s>1e-9?(1-e)*i[r]/s:(1-e)/n.length;i[t]=n.length?e:1}var KS=i=>i?vc(Math.atan2(...i)*180/Math.PI,1):null,vc=(i,t)=>Math.round(i*10**t)/10**t,jS=i=>i===null?null:[Math.sin,Math.cos].map(t=>vc(t(i*Math.PI/180),6));function Am(i,t,{select:e,edit:n,remove:s}){let r=St("div","tkd-form",i,{role:"form",ariaLabel:"What is selected"}),o="",a=null,l=0,c=_=>a?_[t.selected][a][l]:_[t.selected],h=()=>c(t.shots),d=_=>n(y=>{_(c(y))});function u(_,y,R,A=bm,C="input"){let N=St("label","",r,{textContent:_}),O=St(C,"",N,A),{type:I}=O,k=!1;return O.refresh=()=>{I==="checkbox"?O.checked=y():k||(O.value=y()??"")},O.oninput=()=>k=I==="number"||I==="text",O.onchange=()=>{k=!1;let D=O.value===""?null:Number(O.value);d(L=>R(L,I==="checkbox"?O.checked:I==="number"?D:O.value)),O.refresh()},O}let f=(_,y,R)=>u(_,()=>h()[y],(A,C)=>A[y]=C,R),m=(_,y,R,A)=>{let C=u(_,R,A,{},"select");for(let N of y)St("option","",C,{value:N,textContent:N})};function v(_){for(let y of ZS[a])(a!=="holds"||y==="seconds"||_[y]!==null)&&f(YS[y],y);a==="pins"&&p(Bu(_)),a==="path"&&u("faces, °",()=>KS(h().facing),(y,R)=>y.facing=jS(R)),_.easing&&m("easing",Object.keys(hr),()=>h().easing,(y,R)=>y.easing=R),Array.isArray(_.blend)?St("p","",r,{textContent:"A blend by layer; change it in the file."}):_.blend&&g(Object.keys(_.blend))}function p(_){_.length===1&&m("pins",Em,()=>Bu(h())[0],(y,R)=>Object.assign(y,{[_[0]]:null,[R]:y[_[0]]}));for(let y of _)["x","y","z"].forEach((R,A)=>u(`${_.length>1?`${y.replace("_"," ")} `:""}${R}, m`,()=>h()[y]?.[A],(C,N)=>C[y][A]=N))}function g(_){_.forEach((R,A)=>{let C=St("div","tkd-mix",r),N=St("select","",C,{ariaLabel:`Style ${A+1}`});for(let D of t.styles)St("option","",N,{value:D,textContent:t.data.labels[D],disabled:D!==R&&_.includes(D)});N.value=R,N.onchange=()=>d(D=>{D.blend=Object.fromEntries(Object.entries(D.blend).map(([L,B])=>[L===R?N.value:L,B]))});let O=St("input","",C,{type:"range",min:0,max:100,ariaLabel:`Share of ${R}, percent`}),I=St("span","",C),k=()=>Math.round(100*(h().blend[R]??0));O.refresh=()=>{N.style.borderLeft=`8px solid ${Ou(t,R)}`,O.value=k(),I.textContent=`${k()} %`},O.onpointerdown=()=>t.begin(),O.oninput=()=>d(D=>ku(D.blend,R,O.value/100)),O.onchange=()=>t.end(),Re(C,"×",`Take ${R} out of the blend`,()=>d(D=>{ku(D.blend,R,0),delete D.blend[R]})).disabled=_.length<2});let y=t.styles.find(R=>!_.includes(R));y&&Re(r,"+ style in this blend","Add a style to this blend",()=>d(R=>ku(R.blend,y,1/(_.length+1))))}function x({look_at:_,facing:y}){f("name","name",{type:"text",maxLength:100}),f("seed","seed",{type:"number",step:1,min:0}),f("duration, s","duration",{...bm,placeholder:"to the end"}),m("faces",yc,()=>yc[t.shot.look_at?2:t.shot.facing?1:0],(O,I)=>Object.assign(O,{look_at:I===yc[2]?[0,0]:null,facing:I===yc[1]?[0,1]:null}));let R=_?"look_at":y&&"facing";R&&["x","z"].forEach((O,I)=>u(_?`${O} of it, m`:`to ${O}`,()=>h()[R]?.[I],(k,D)=>k[R][I]=D));for(let[O,I]of Object.entries(JS))f(I,O,{type:"checkbox"});let A=St("div","tkd-row",r),C=()=>Math.round(100*t.seconds)/100,N=(O,I,k)=>Re(A,O,I,()=>n(D=>{let{selected:L}=t;D[L]=k(D[L],t.take(L).course)}));N("Mirror","Mirror this shot: left and right change places",gm),N("Reverse","Walk the path from its end to its start",_m),N("Cut before","Cut off what is before this time",(O,I)=>Du(O,I,C())),N("Cut after","Cut off what is after this time",(O,I)=>Du(O,I,0,C())),Re(A,"Join next","Put the shot of the next character at the end of this one",()=>n(O=>{let{selected:I}=t;if(!O[I+1])throw new Error("the last character has no next one whose shot can be joined");O.splice(I,2,xm(O[I],t.take(I).course,O[I+1],t.take(I+1).course,t))}))}function b(_){let y=Math.round(100*t.seconds)/100,{rules:{FPS:R}}=t,{[_]:A}=t.shot;A.findIndex(N=>N.time!==null&&Math.abs(N.time-y)<wm)<0&&n(N=>{let{course:{speed:O}}=t.take(t.selected),I=O[Math.min(Math.round(y*R),O.length-1)],k={styles:()=>({blend:fc(A,y),easing:"smooth"}),holds:()=>({seconds:1,distance:null}),speeds:()=>({speed:vc(I||zo(t.shot.styles[0].blend,t),2),easing:"smooth"})},{[_]:D}=N[t.selected];D.push({time:y,...k[_]()}),D.sort((L,B)=>L.time-B.time)}),e({list:_,k:t.shot[_].findIndex(N=>N.time!==null&&Math.abs(N.time-y)<wm)})}function M(){let _=Math.round(100*t.seconds)/100,{data:{figure:y},rules:{FPS:R}}=t,A=t.joints(t.selected,Math.max(Math.round(_*R)-1,0))[y.arms[0][2]].map(C=>vc(C,2));n(C=>{C[t.selected].pins.push({at:_,right_hand:A})}),e({list:"pins",k:t.shot.pins.length-1})}function E(){let _=a==="path"?l:t.shot.path.length-1;n(y=>{let{path:R}=y[t.selected],{[_]:A,[_+1]:C,[_-1]:N}=R,O=C?{x:(A.x+C.x)/2,z:(A.z+C.z)/2}:{x:2*A.x-N.x,z:2*A.z-N.z};R.splice(_+1,0,{...O,time:null,facing:null})}),e({list:"path",k:_+1})}function S(){let _=()=>[...r.querySelectorAll("input,select,button")],y=_().indexOf(document.activeElement);r.replaceChildren(),St("h3","",r,{textContent:a?`${Fu[a]} ${l+1}`:"Shot"}),a?a!=="ghosts"&&v(h()):x(t.shot);let R=St("div","tkd-row",r);a&&Re(R,"Delete",`Delete this ${Fu[a].toLowerCase()}`,s),(!a||a==="path")&&Re(R,"+ point","Add a point to the path",E),Re(R,"+ pin","Add a pin at this time",M);for(let[A,C]of[["styles","+ style"],["speeds","+ speed"],["holds","+ pause"]])Re(R,C,`Add a ${Fu[A].toLowerCase()} at this time`,()=>b(A));y>=0&&_()[y]?.focus({preventScroll:!0})}return{draw(_){a=_?.list==="arrivals"?"path":_?.list??null,l=_?.k??0;let y=a&&a!=="ghosts"?h():null,{look_at:R,facing:A}=t.shot,C=JSON.stringify([a,l,t.selected,y?.blend&&Object.keys(y.blend),y?.distance===null,!R,!A,Bu(y)]);C!==o&&(o=C,S());for(let N of r.querySelectorAll("input,select"))N.refresh?.()}}}var QS=`
.tkd{--ink:#2b323b;--soft:#6d7580;--line:#ddd8ce;--accent:#7b68c4;display:grid;gap:8px;height:100%;min-height:0;color:var(--ink);
 font:13px/1.4 system-ui,-apple-system,"Segoe UI",Roboto,sans-serif;grid:auto minmax(0,1fr) auto/minmax(0,1.25fr) minmax(0,1fr) 250px;
 grid-template-areas:"bar bar bar" "stage map side" "time time time"}
.tkd *{box-sizing:border-box}.tkd [hidden]{display:none!important}
.tkd button,.tkd select,.tkd input{font:inherit;color:inherit}
.tkd button,.tkd select,.tkd input:not([type=range],[type=checkbox]){border:1px solid var(--line);background:#fff;border-radius:8px;height:30px;padding:0 9px}
.tkd button{cursor:pointer}.tkd button:disabled{opacity:.4;cursor:default}.tkd:focus{outline:none}
.tkd :focus-visible{outline:2px solid var(--accent);outline-offset:1px}
.tkd button[aria-pressed=true],.tkd button[aria-selected=true]{background:#efecfa;border-color:#c9c0ec;color:#4c3fa0}
.tkd-bar,.tkd-row{display:flex;flex-wrap:wrap;gap:6px;align-items:center}.tkd-bar{grid-area:bar}
.tkd-bar [role=tablist]{display:flex;gap:4px;flex-wrap:wrap;margin-right:auto;max-height:68px;overflow:auto}
.tkd-bar [role=tab]{max-width:14em;overflow:hidden;text-overflow:ellipsis;white-space:nowrap;border-bottom:3px solid var(--tone)!important}
.tkd-box{position:relative;min-height:0;min-width:0;overflow:hidden;border-radius:12px;background:#f3f1ec}
.tkd-stage{position:absolute;inset:0}.tkd-stage canvas{display:block}
.tkd-tools{position:absolute;left:8px;top:8px;display:flex;gap:5px}
.tkd-say{position:absolute;left:8px;right:8px;bottom:8px;max-height:60%;overflow:auto;display:grid;gap:4px;justify-items:start}.tkd-say p{margin:0;padding:3px 9px;border-radius:8px;background:#fff4e0;color:#7a4b00;overflow-wrap:anywhere}
.tkd-say .bad{background:#fde4e1;color:#8c1d13}
.tkd-map,.tkd-time{display:block;width:100%;touch-action:none;user-select:none;-webkit-user-select:none}
.tkd-map{height:100%;cursor:grab}
.tkd-map.drawing{cursor:crosshair}.tkd path{stroke-linejoin:round}.tkd .hollow{fill:none}.tkd .grid{stroke:#ddd8ce;stroke-width:1}
.tkd .axes{stroke:#b9b2a3;stroke-width:1.5}
.tkd-map .plan{stroke-width:3}.tkd-map .walked{stroke-width:1.5;stroke:#2b323b;stroke-opacity:.45}
.tkd .off{stroke:#d03a2b;stroke-width:4;stroke-linecap:round}
.tkd-map .stroke{stroke:var(--accent);stroke-width:3;stroke-dasharray:6 4}.tkd-map circle{stroke-width:2.5;cursor:move}
.tkd-map circle.on{fill:var(--ink)}.tkd-map .pin{fill:#d03a2b;stroke:#fff;stroke-width:1.5;cursor:move}.tkd-map .pin.on{stroke:var(--ink)}
.tkd-map .person{stroke:#fff;stroke-width:1;cursor:pointer}.tkd-map .walls{stroke:#6d7580;stroke-width:5;stroke-linecap:round}.tkd-map text{font-size:11px;fill:var(--soft);pointer-events:none}
.tkd-low{grid-area:time;background:#fbfaf7;border-radius:12px;overflow:hidden}
.tkd-time text{font-size:10px;fill:var(--soft);pointer-events:none}.tkd-time .names text{font-size:11px;fill:#1d232b}
.tkd-time .ruler{fill:#efece5;cursor:ew-resize}.tkd-time .speed{stroke:#2b323b;stroke-width:1.5}.tkd-time .off{stroke-width:3}
.tkd-time .now{stroke:var(--accent);stroke-width:2;pointer-events:none}
.tkd-time .grid,.tkd-time .speed,.tkd-time .off{pointer-events:none}
.tkd-time .pause{fill:#c9a22755}.tkd-time g path.key{fill:#fff;stroke:#2b323b;stroke-width:1.6;cursor:grab}
.tkd-time g path.key.on{fill:#2b323b}
.tkd-time g path.ghosts{stroke:#7b68c4}.tkd-time g path.pins{stroke:#d03a2b}.tkd-time g path.holds{stroke:#8a6d10}
.tkd-time .defect{fill:#d03a2b}.tkd-found{margin:0;padding:1px 14px 4px;color:var(--soft);min-height:1.9em}.tkd-found.bad{color:#8c1d13}
.tkd-side,.tkd-form{display:flex;flex-direction:column;gap:8px}.tkd-side{grid-area:side;overflow:auto;padding:2px}
.tkd-side h3{margin:0;font-size:14px}.tkd-side label{display:grid;grid-template-columns:84px 1fr;gap:6px;align-items:center}
.tkd-side label input,.tkd-side label select{min-width:0;width:100%}.tkd-side input[type=checkbox]{width:auto;justify-self:start}
.tkd-mix{display:grid;grid-template-columns:minmax(0,1.3fr) minmax(0,1fr) 42px 26px;gap:5px;align-items:center}
.tkd-mix button{padding:0;height:26px}.tkd-mix select,.tkd-mix input{min-width:0;width:100%}
.tkd-clock{font-variant-numeric:tabular-nums;color:var(--soft);min-width:7.5em}
@media(max-width:900px){.tkd{display:flex;flex-direction:column;overflow:auto}.tkd>*{flex:none}
.tkd-box{height:clamp(190px,28dvh,420px)}.tkd-side{overflow:visible;order:1}}
`,Tm=150,tb=20,eb=700,nb=12,ib=2;function zu({model:i,el:t}){let e=St("div","tkd",t,{tabIndex:-1});e.dataset.lmSuppressShortcuts="true",i.get("height")&&(e.style.height=`${i.get("height")}px`),St("style","",e,{textContent:QS});let n=i.get("data"),s=[],r=null,o=!1,a=0,l=0,c=!0,h=0,d=0,u=Tm,f=null,m,v=!1,p="",g=null,x=new mc(n,i.get("scene"),dt);x.seconds=0;let b=x.rules.FPS,M=St("div","tkd-bar",e),E=St("div","",M,{role:"tablist",ariaLabel:"Characters"}),S=St("div","tkd-box",e),_=St("div","tkd-stage",S),y=St("div","tkd-box",e);S.style.gridArea="stage",y.style.gridArea="map";let R=St("div","tkd-side",e),A=St("div","tkd-low",e),C=dm(y,x,{select:Jt,edit:Ct}),N=Sm(A,x,{select:Jt,edit:Ct,seek:Ht,ghosts:s}),O=St("p","tkd-found",A,{role:"status",ariaLabel:"Defects"}),I=Am(R,x,{select:Jt,edit:Ct,remove:ct}),k=St("div","tkd-say",S,{role:"status",ariaLabel:"What cannot be met"});Re(M,"+ character","Add a character",()=>Ct(Z=>{let Bt=JSON.parse(JSON.stringify(x.shot)),yt=Z.length,Pt=Math.min(...Z.map(({path:[{x:w}]})=>w)),P=Math.max(ib,x.more.apart??0,...Z.map(({radius:w})=>2*(w??0)));for(let w of Bt.path)w.x+=Pt-x.shot.path[0].x-P;Z.push({...Bt,name:`shot ${yt+1}`,seed:Bt.seed+1}),x.selected=yt}));let D=Re(M,"− character","Remove this character",()=>Ct(Z=>{Z.splice(x.selected,1)})),L=Re(M,"▶","Play",()=>Mt(!o)),B=St("span","tkd-clock",M),z=Re(M,"↶","Undo",()=>x.undo()),F=Re(M,"↷","Redo",()=>x.redo());Re(M,"Onion skin","Onion skin at this time, or away with it",()=>{let Z=s.findIndex(Bt=>Math.abs(Bt-x.seconds)<.05);Z<0?s.push(Math.round(100*x.seconds)/100):s.splice(Z,1),dt("look")});let X=St("input","",M,{type:"file",accept:".json,application/json",hidden:!0,ariaLabel:"File of shots"});Re(M,"Open","Open a file of shots",()=>X.click()),X.onchange=async()=>{let[Z]=X.files;try{Z&&Kt(JSON.parse(await Z.text()))}catch(Bt){Xt(`${Z.name}: ${Bt instanceof SyntaxError?"not a JSON file of shots":Bt.message}`)}X.value=""};let et=Z=>`${x.shot.name.replace(/[^\w.+-]+/g,"_")||"shot"}.${Z}`;Re(M,"Save","Save the shots as JSON",()=>Oo("shots.json",JSON.stringify(x.scene,null,1)+`
`));let W=(Z,Bt)=>Re(M,Z.toUpperCase(),`Export the motion of this character as ${Z.toUpperCase()}`,()=>{try{Oo(et(Z),Bt(x.motion(x.selected)))}catch(yt){Xt(yt.message)}});W("glb",Z=>fm({...n.skeleton,names:n.joints},Z,b,x.shot.name,at)),W("bvh",Z=>Lc(n.bvh,Z,b));let U=St("div","tkd-tools",y),Q=Re(U,"Draw","Draw the path with the next drag",()=>C.toggle());Re(U,"Fit","Show all paths",()=>{C.fit(),dt("look")});let K=null;try{K=new ei(_,n.skeleton,{facing:Math.PI,distance:6}),K.controls.enableDamping=!1,K.controls.maxDistance=30,K.controls.addEventListener("change",()=>c=!0)}catch{_.textContent="This browser offers no WebGL, which the character needs."}let at=n.skeleton.mesh.own?null:Lo(n.skeleton.mesh),ot=K?[K.body]:[],It=[];function Xt(Z){p=Z,dt("look")}function Ct(Z){try{x.change(Z),p=""}catch(Bt){Xt(Bt.message)}}function Kt(Z){let Bt=x.shots;x.open(Z),p="",x.shots!==Bt&&(C.fit(),dt("look"))}function Jt(Z){r?.list===Z?.list&&r?.k===Z?.k||(r=Z,dt("look"))}function Ht(Z){x.seconds=Math.min(Math.max(Z,0),Tt()),dt("look")}function Mt(Z){o=Z,a=0,L.textContent=Z?"❚❚":"▶",L.ariaLabel=L.title=Z?"Pause":"Play",Z&&x.seconds>=Tt()-.01&&Ht(0)}let Tt=()=>Math.max(...x.shots.map((Z,Bt)=>x.take(Bt).count))/b;function dt(Z){(!(Z==="frames"&&x.making.some(Boolean))||performance.now()-d>u)&&(c=!0),!(Z!=="kept"||v)&&(i.set("scene",x.scene),i.save_changes())}let Rt=()=>{v=!0,Kt(JSON.parse(JSON.stringify(i.get("scene")))),v=!1},Vt=()=>{try{x.filled(i.get("motion")??{})}catch(Z){Xt(Z.message)}};i.on("change:scene",Rt),i.on("change:motion",Vt);function ct(){let{list:Z,k:Bt}=r;r=null,Z==="ghosts"?s.splice(Bt,1):Ct(Z==="arrivals"?yt=>{yt[x.selected].path[Bt].time=null}:yt=>{yt[x.selected][Z].splice(Bt,1)}),dt("look")}function Lt(){for(;E.children.length>x.shots.length;)E.lastChild.remove();x.shots.forEach((yt,Pt)=>{let P=E.children[Pt]??Re(E,"","",()=>(x.selected=Pt,r=null,dt("look")));P.role="tab",P.ariaSelected=String(Pt===x.selected),P.style.setProperty("--tone",Go(Pt)),P.textContent!==yt.name&&(P.textContent=P.title=P.ariaLabel=yt.name)}),D.disabled=x.shots.length<2,z.disabled=!x.past.length,F.disabled=!x.future.length,Q.ariaPressed=String(C.drawing);let Bt=!x.making.some(yt=>yt&&performance.now()-yt.since>(x.network?eb:-1))||p?"":x.network?`, ${Math.round(100*x.share)} % ready`:", the kernel renders";B.textContent=`${x.seconds.toFixed(2)} / ${Tt().toFixed(2)} s${Bt}`}function Ft(){let{more:{apart:Z}}=x,Bt=({name:P})=>x.shots.length>1?`${P}: `:"";if(x.making.some(Boolean)&&!p&&x.takes.every(Boolean))return;let yt=x.takes.every(Boolean)?Z===void 0?x.shots.flatMap((P,w)=>[...lm(x.take(w),x.limits),...x.missedPins(w)].map($=>Bt(P)+$)):[`All keep ${Z} m apart, or their own radii: they leave their paths for it, and their plans wait where they are held up.`]:[],Pt=[p,...yt].join(`
`);Pt!==m&&(m=Pt,k.replaceChildren(...[p,...yt].flatMap((P,w)=>P?[St("p",w?"":"bad",null,{textContent:P})]:[])))}function Qt(){let{findings:Z,data:{gate:Bt}}=x,yt=Z?Np(Z,Bt,x.shots.map(Pt=>Pt.name)):"";O.textContent!==yt&&(O.textContent=O.title=yt),O.classList.toggle("bad",!!Z?.length)}function H(Z,Bt,yt,Pt,P){let w=x.pose(yt,Math.round(Pt*b)-1),$=Z[Bt]??=K.add({ghost:P});K.show($,!!w),w&&($.pose(w.root,w.rotations),P||$.setContacts({right:w.contacts[0]>.5,left:w.contacts[1]>.5}),!P&&yt===x.selected&&K.follow(w.root[0]*$.scale,w.root[2]*$.scale,{jump:!0}))}function _e(Z){let Bt=Math.round(x.seconds*b)-1,yt={...x.shot,ghosts:s,arrivals:x.shot.path};if(r&&yt[r.list][r.k]===void 0&&(r=null),Lt(),I.draw(r),Ft(),Qt(),C.draw(r,Math.max(Bt,0)),N.draw(r,x.seconds),f&&(!f.isConnected||f.disabled)&&document.activeElement===document.body&&e.focus({preventScroll:!0}),!K)return;x.shots.forEach((nt,ht)=>H(ot,ht,ht,x.seconds,!1));let Pt=x.take(x.selected),{curve:{x:P,z:w,at:$}}=Pt.course,lt=Pt.course.distance[Math.max(Bt,0)];Pt!==g&&K.setTrail(Float32Array.from(P.flatMap((nt,ht)=>[nt*K.body.scale,0,w[ht]*K.body.scale]))),g=Pt,K.showTrail(lt===void 0?$.length:cr($,lt)-1),K.setMarks(x.shot.pins.flatMap(nt=>Ye.concat("look").flatMap(ht=>nt[ht]?[nt[ht].map(mt=>mt*K.body.scale)]:[]))),s.forEach((nt,ht)=>H(It,ht,x.selected,nt,!0)),ot.slice(x.shots.length).concat(It.slice(s.length)).forEach(nt=>K.show(nt,!1)),K.render({still:Z}),x.stats.drawn=(x.stats.drawn??0)+1}function ce(Z){if(l=requestAnimationFrame(ce),!(document.hidden||!e.clientWidth))if(o&&(Ht(x.seconds+Math.min((Z-(a||Z))/1e3,.25)),a=Z,x.seconds>=Tt()-1e-9&&Mt(!1)),c){c=!1,h=0;let Bt=performance.now();_e(!1),d=performance.now(),u=Math.max(Tm,tb*(d-Bt))}else++h===nb&&_e(!0)}e.addEventListener("focusin",Z=>f=Z.target),e.addEventListener("keydown",Z=>{let Bt=Z.ctrlKey||Z.metaKey,{target:yt}=Z,Pt=/INPUT|SELECT/.test(yt.tagName)&&yt.type!=="range";if(Bt&&/^[zy]$/i.test(Z.key))Z.key.toLowerCase()==="y"||Z.shiftKey?x.redo():x.undo();else if(!Pt&&Z.key===" "&&yt.tagName!=="BUTTON")Mt(!o);else if(!Pt&&r&&(Z.key==="Delete"||Z.key==="Backspace"))ct();else return;Z.preventDefault(),Z.stopPropagation()});let pe=new ResizeObserver(()=>dt("look"));return pe.observe(y),pe.observe(A),C.fit(),Vt(),t.toolkit={desk:x,scene:K,map:C,ghosts:s,seek:Ht,run:Mt,open:Kt,get stats(){return x.stats}},l=requestAnimationFrame(ce),()=>{cancelAnimationFrame(l),pe.disconnect(),i.off("change:scene",Rt),i.off("change:motion",Vt),x.dispose(),K?.dispose()}}function sb(i,t){let e=new Yo(t);return e.download=n=>Oo("walk.bvh",n),e.run(),Mu({model:e,el:i}),{kernel:e,...i.toolkit}}function rb(i,{scene:t,...e}){return zu({model:new wr({data:e,scene:t,height:null}),el:i}),i.toolkit}function Rm(i,t=600){if(!i.isConnected&&t)return requestAnimationFrame(()=>Rm(i,t-1));for(let e of i.closest(".jp-OutputArea, .output")?.querySelectorAll(".tk-still")??[])e.hidden=!0}function ob({model:i,el:t}){return Rm(t),(i.get("data")?zu:i.get("clips")?Wp:Mu)({model:i,el:t})}globalThis.toolkitScene={Crowd:pr,Scene:ei,character:sb,director:rb,player:yu};var vT={render:ob};export{ei as Scene,sb as character,vT as default,rb as director,yu as player};
