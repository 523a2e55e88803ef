// The words of the page in the program's six languages.

/** @import {Loaded} from './program.js' */

export const languages = ['en', 'de', 'fr', 'es', 'it', 'ja'];

/** Each word in the order of `languages`. @type {Record<string, string[]>} */
export const all_words = {
  play: ['Play', 'Abspielen', 'Lecture', 'Reproducir', 'Riproduci', '再生'],
  pause: ['Pause', 'Anhalten', 'Pause', 'Pausa', 'Pausa', '一時停止'],
  go_on: ['Go on', 'Weiter', 'Continuer', 'Continuar', 'Continua', '続ける'],
  previous_stop: ['Previous stop', 'Voriger Halt', 'Arrêt précédent', 'Parada anterior', 'Sosta precedente', '前の停止点'],
  next_stop: ['Next stop', 'Nächster Halt', 'Arrêt suivant', 'Parada siguiente', 'Sosta successiva', '次の停止点'],
  time: ['Time', 'Zeit', 'Temps', 'Tiempo', 'Tempo', '時間'],
  speed: ['Speed', 'Tempo', 'Vitesse', 'Velocidad', 'Velocità', '速度'],
  backwards: ['Backwards', 'Rückwärts', 'À rebours', 'Hacia atrás', 'All’indietro', '逆再生'],
  film: ['film', 'Film', 'film', 'película', 'film', '映像'],
  at_seam: ['goes on at the seam', 'weiter an der Nahtstelle', 'suite à la jointure', 'sigue en la unión', 'prosegue alla giunzione', '継ぎ目で続行'],
  key_blank: ['black, white screen', 'schwarzer, weißer Schirm', 'écran noir, blanc', 'pantalla negra, blanca', 'schermo nero, bianco', '黒い・白い画面'],
  repeat: ['Repeat', 'Wiederholen', 'Répéter', 'Repetir', 'Ripeti', '繰り返し'],
  full_screen: ['Full screen', 'Vollbild', 'Plein écran', 'Pantalla completa', 'Schermo intero', '全画面'],
  options: ['Options', 'Einstellungen', 'Réglages', 'Opciones', 'Opzioni', '設定'],
  close: ['Close', 'Schließen', 'Fermer', 'Cerrar', 'Chiudi', '閉じる'],
  change: ['Change the motion', 'Bewegung ändern', 'Modifier le mouvement', 'Cambiar el movimiento', 'Modifica il moto', '運動を変える'],
  motion: ['Motion', 'Bewegung', 'Mouvement', 'Movimiento', 'Moto', '運動'],
  original: ['As in the scene', 'Wie in der Szene', 'Comme dans la scène', 'Como en la escena', 'Come nella scena', 'シーンの値に戻す'],
  show: ['Show', 'Anzeigen', 'Afficher', 'Mostrar', 'Mostra', '表示'],
  names: ['Names', 'Namen', 'Noms', 'Nombres', 'Nomi', '名前'],
  view: ['View', 'Ansicht', 'Vue', 'Vista', 'Vista', '視点'],
  scene_view: ['The scene’s view', 'Ansicht der Szene', 'Vue de la scène', 'Vista de la escena', 'Vista della scena', 'シーンの視点'],
  look: ['Colours', 'Farben', 'Couleurs', 'Colores', 'Colori', '配色'],
  of_scene: ['The scene’s', 'Der Szene', 'De la scène', 'De la escena', 'Della scena', 'シーン'],
  light: ['Light', 'Hell', 'Clair', 'Claro', 'Chiaro', 'ライト'],
  dark: ['Dark', 'Dunkel', 'Sombre', 'Oscuro', 'Scuro', 'ダーク'],
  save: ['Save and share', 'Speichern und teilen', 'Enregistrer et partager', 'Guardar y compartir', 'Salva e condividi', '保存と共有'],
  save_png: ['Save PNG', 'PNG speichern', 'Enregistrer en PNG', 'Guardar PNG', 'Salva PNG', 'PNG を保存'],
  save_svg: ['Save SVG', 'SVG speichern', 'Enregistrer en SVG', 'Guardar SVG', 'Salva SVG', 'SVG を保存'],
  width: ['Width', 'Breite', 'Largeur', 'Anchura', 'Larghezza', '幅'],
  height: ['Height', 'Höhe', 'Hauteur', 'Altura', 'Altezza', '高さ'],
  copy_link: ['Copy link', 'Link kopieren', 'Copier le lien', 'Copiar enlace', 'Copia link', 'リンクをコピー'],
  copied: ['Link copied', 'Link kopiert', 'Lien copié', 'Enlace copiado', 'Link copiato', 'リンクをコピーしました'],
  link: ['Link to this instant', 'Link zu diesem Augenblick', 'Lien vers cet instant', 'Enlace a este instante', 'Link a questo istante', 'この時刻へのリンク'],
  notes: ['Notes', 'Notizen', 'Notes', 'Notas', 'Note', 'ノート'],
  next: ['Next', 'Als Nächstes', 'Ensuite', 'Después', 'Poi', '次'],
  end: ['End', 'Ende', 'Fin', 'Fin', 'Fine', '終わり'],
  planned: ['Planned', 'Geplant', 'Prévu', 'Previsto', 'Previsto', '予定'],
  elapsed: ['Elapsed', 'Vergangen', 'Écoulé', 'Transcurrido', 'Trascorso', '経過'],
  keys: ['Keys', 'Tasten', 'Touches', 'Teclas', 'Tasti', 'キー'],
  figure: ['Figure', 'Bild', 'Figure', 'Figura', 'Figura', '図'],
  stop: ['Stop', 'Halt', 'Arrêt', 'Parada', 'Sosta', '停止点'],
  start_figure: ['Start the figure', 'Bild starten', 'Démarrer la figure', 'Iniciar la figura', 'Avvia la figura', '図を開始'],
  film_section: ['Film', 'Film', 'Film', 'Película', 'Film', '映像'],
  film_make: ['Make film', 'Film erstellen', 'Créer le film', 'Crear película', 'Crea film', '映像を作成'],
  film_cancel: ['Cancel', 'Abbrechen', 'Annuler', 'Cancelar', 'Annulla', 'キャンセル'],
  film_kind: ['Format', 'Format', 'Format', 'Formato', 'Formato', '形式'],
  film_span: ['Span', 'Abschnitt', 'Extrait', 'Tramo', 'Tratto', '範囲'],
  film_rate: ['Frames a second', 'Bilder je Sekunde', 'Images par seconde', 'Imágenes por segundo', 'Immagini al secondo', '毎秒フレーム数'],
  film_quality: ['Quality', 'Qualität', 'Qualité', 'Calidad', 'Qualità', '品質'],
  film_whole: ['Whole film', 'Ganzer Film', 'Film entier', 'Película entera', 'Film intero', '全体'],
  film_pictures: ['PNG pictures (ZIP)', 'PNG-Bilder (ZIP)', 'Images PNG (ZIP)', 'Imágenes PNG (ZIP)', 'Immagini PNG (ZIP)', 'PNG 画像 (ZIP)'],
  film_slides: ['Slides (ZIP)', 'Folien (ZIP)', 'Diapositives (ZIP)', 'Diapositivas (ZIP)', 'Diapositive (ZIP)', 'スライド (ZIP)'],
  film_left: ['time left:', 'Restzeit:', 'temps restant :', 'tiempo restante:', 'tempo rimasto:', '残り時間:'],
  film_saved: ['The film is saved.', 'Der Film ist gespeichert.', 'Le film est enregistré.', 'La película está guardada.', 'Il film è salvato.', '映像を保存しました。'],
  film_cancelled: ['Cancelled; nothing was saved.', 'Abgebrochen; es wurde nichts gespeichert.', 'Annulé ; rien n’a été enregistré.', 'Cancelado; no se guardó nada.', 'Annullato: niente è stato salvato.', 'キャンセルしました。何も保存されていません。'],
  film_disk: ['The disk is full; nothing was saved. Free space, or make a smaller film.', 'Der Datenträger ist voll; es wurde nichts gespeichert. Schaffen Sie Platz, oder wählen Sie einen kleineren Film.', 'Le disque est plein ; rien n’a été enregistré. Libérez de l’espace ou créez un film plus petit.', 'El disco está lleno; no se guardó nada. Libere espacio o haga una película más pequeña.', 'Il disco è pieno: niente è stato salvato. Liberi spazio o crei un film più piccolo.', 'ディスクがいっぱいです。何も保存されていません。空きを作るか、映像を小さくしてください。'],
  film_lost: ['The browser took the graphics memory away; nothing was saved. Make the film again.', 'Der Browser hat den Grafikspeicher entzogen; es wurde nichts gespeichert. Erstellen Sie den Film noch einmal.', 'Le navigateur a repris la mémoire graphique ; rien n’a été enregistré. Recommencez.', 'El navegador retiró la memoria gráfica; no se guardó nada. Repita la película.', 'Il browser ha ripreso la memoria grafica: niente è stato salvato. Rifaccia il film.', 'ブラウザーがグラフィックスメモリーを回収しました。何も保存されていません。もう一度作成してください。'],
  film_failed: ['The film failed; nothing was saved:', 'Der Film ist misslungen; es wurde nichts gespeichert:', 'Le film a échoué ; rien n’a été enregistré :', 'La película falló; no se guardó nada:', 'Il film non è riuscito: niente è stato salvato:', '映像の作成に失敗しました。何も保存されていません:'],
  film_even: ['A film needs an even width and height; change the size, or choose PNG pictures.', 'Ein Film braucht gerade Breite und Höhe; ändern Sie die Größe, oder wählen Sie PNG-Bilder.', 'Un film demande une largeur et une hauteur paires ; changez la taille ou choisissez les images PNG.', 'Una película necesita anchura y altura pares; cambie el tamaño o elija imágenes PNG.', 'Un film vuole larghezza e altezza pari: cambi la dimensione o scelga le immagini PNG.', '映像の幅と高さは偶数でなければなりません。サイズを変えるか、PNG 画像を選んでください。'],
  film_no_encoder: ['This browser cannot encode such a film; choose another format or size, or PNG pictures.', 'Dieser Browser kann einen solchen Film nicht codieren; wählen Sie ein anderes Format, eine andere Größe oder PNG-Bilder.', 'Ce navigateur ne peut pas encoder un tel film ; choisissez un autre format, une autre taille ou les images PNG.', 'Este navegador no puede codificar esa película; elija otro formato, otro tamaño o imágenes PNG.', 'Questo browser non può codificare un tale film: scelga un altro formato, un’altra dimensione o le immagini PNG.', 'このブラウザーではこの映像を符号化できません。別の形式やサイズ、または PNG 画像を選んでください。'],
  film_no_h264: ['This browser has no H.264 of this size, so the film is', 'Dieser Browser hat für diese Größe kein H.264; der Film ist daher', 'Ce navigateur n’a pas H.264 à cette taille ; le film est donc en', 'Este navegador no tiene H.264 de este tamaño; la película es', 'Questo browser non ha H.264 di questa dimensione: il film è', 'このブラウザーではこのサイズの H.264 を使えないため、映像の符号化方式は次のとおりです:'],
  film_opaque: ['The film has a white ground; WebM and PNG pictures keep transparency.', 'Der Film hat einen weißen Grund; WebM und PNG-Bilder behalten die Transparenz.', 'Le film a un fond blanc ; WebM et les images PNG gardent la transparence.', 'La película tiene fondo blanco; WebM y las imágenes PNG conservan la transparencia.', 'Il film ha uno sfondo bianco; WebM e le immagini PNG mantengono la trasparenza.', '映像の背景は白になります。WebM と PNG 画像では透明度が保たれます。'],
  film_size: ['A frame of {size} pixels needs more memory than a tab of the browser has; choose at most {most} million pixels.', 'Ein Bild von {size} Pixeln braucht mehr Speicher, als ein Tab des Browsers hat; wählen Sie höchstens {most} Millionen Pixel.', 'Une image de {size} pixels demande plus de mémoire que n’en a un onglet du navigateur ; choisissez au plus {most} millions de pixels.', 'Una imagen de {size} píxeles necesita más memoria de la que tiene una pestaña; elija como máximo {most} millones de píxeles.', 'Un’immagine di {size} pixel vuole più memoria di quanta ne abbia una scheda del browser: scelga al massimo {most} milioni di pixel.', '{size} ピクセルの画像には、ブラウザーのタブより多くのメモリーが必要です。{most} 百万ピクセル以下にしてください。'],
  film_chapters: ['An MP4 film made in a page holds 255 chapters; the last {n} are left out.', 'Ein MP4-Film, den eine Seite erstellt, fasst 255 Abschnitte; die letzten {n} fehlen.', 'Un film MP4 créé dans une page contient 255 chapitres ; les {n} derniers manquent.', 'Una película MP4 hecha en una página contiene 255 capítulos; faltan los últimos {n}.', 'Un film MP4 fatto in una pagina contiene 255 capitoli: mancano gli ultimi {n}.', 'ページで作る MP4 のチャプターは 255 個までです。最後の {n} 個は含まれません。'],
  film_camera: ['The film has the scene’s view.', 'Der Film hat die Ansicht der Szene.', 'Le film a la vue de la scène.', 'La película tiene la vista de la escena.', 'Il film ha la vista della scena.', '映像はシーンの視点になります。'],
  quality_draft: ['Draft', 'Entwurf', 'Brouillon', 'Borrador', 'Bozza', '下書き'],
  quality_lecture: ['Lecture', 'Vorlesung', 'Cours', 'Clase', 'Lezione', '講義'],
  quality_print: ['Print', 'Druck', 'Impression', 'Impresión', 'Stampa', '印刷'],
  quality_reference: ['Reference', 'Referenz', 'Référence', 'Referencia', 'Riferimento', '基準'],
  turns_over: ['The body turns over every {s} s.', 'Der Körper schlägt alle {s} s um.', 'Le corps se retourne toutes les {s} s.', 'El cuerpo se da la vuelta cada {s} s.', 'Il corpo si capovolge ogni {s} s.', '物体は {s} 秒ごとに反転します。'],
  turns_over_at: ['The body turns over at {s} s.', 'Der Körper schlägt bei {s} s um.', 'Le corps se retourne à {s} s.', 'El cuerpo se da la vuelta a los {s} s.', 'Il corpo si capovolge a {s} s.', '物体は {s} 秒に反転します。'],
  turns_over_once: ['The body turns over once, at {s} s.', 'Der Körper schlägt einmal um, bei {s} s.', 'Le corps se retourne une seule fois, à {s} s.', 'El cuerpo se da la vuelta una sola vez, a los {s} s.', 'Il corpo si capovolge una sola volta, a {s} s.', '物体は {s} 秒に一度だけ反転します。'],
  wobbles_smallest: ['The body wobbles about the axis of its smallest moment, and does not turn over.', 'Der Körper taumelt um die Achse seines kleinsten Trägheitsmoments und schlägt nicht um.', 'Le corps oscille autour de l’axe de son plus petit moment et ne se retourne pas.', 'El cuerpo oscila alrededor del eje de su momento menor y no se da la vuelta.', 'Il corpo oscilla attorno all’asse del suo momento minore e non si capovolge.', '物体は最小の慣性モーメントの軸のまわりで揺れ、反転しません。'],
  wobbles_largest: ['The body wobbles about the axis of its largest moment, and does not turn over.', 'Der Körper taumelt um die Achse seines größten Trägheitsmoments und schlägt nicht um.', 'Le corps oscille autour de l’axe de son plus grand moment et ne se retourne pas.', 'El cuerpo oscila alrededor del eje de su momento mayor y no se da la vuelta.', 'Il corpo oscilla attorno all’asse del suo momento maggiore e non si capovolge.', '物体は最大の慣性モーメントの軸のまわりで揺れ、反転しません。'],
  no_webgl: ['This browser offers no WebGL 2, so you see a still picture. A current browser with hardware acceleration shows the motion.',
    'Dieser Browser bietet kein WebGL 2; darum sehen Sie ein Standbild. Ein aktueller Browser mit Hardwarebeschleunigung zeigt die Bewegung.',
    'Ce navigateur n’offre pas WebGL 2 ; vous voyez donc une image fixe. Un navigateur récent avec accélération matérielle montre le mouvement.',
    'Este navegador no ofrece WebGL 2; por eso ve una imagen fija. Un navegador actual con aceleración por hardware muestra el movimiento.',
    'Questo browser non offre WebGL 2: per questo si vede un’immagine fissa. Un browser recente con accelerazione hardware mostra il moto.',
    'このブラウザーには WebGL 2 がないため、静止画を表示しています。ハードウェアアクセラレーションのある新しいブラウザーなら運動が見られます。'],
  no_wasm: ['WebAssembly is not available or not allowed here, so you see a still picture.',
    'WebAssembly fehlt hier oder ist nicht erlaubt; darum sehen Sie ein Standbild.',
    'WebAssembly est absent ou interdit ici ; vous voyez donc une image fixe.',
    'WebAssembly falta o no está permitido aquí; por eso ve una imagen fija.',
    'WebAssembly manca o non è consentito qui: per questo si vede un’immagine fissa.',
    'ここでは WebAssembly を使えないため、静止画を表示しています。'],
  no_start: ['The figure did not start, so you see a still picture.', 'Das Bild konnte nicht starten; darum sehen Sie ein Standbild.',
    'La figure n’a pas pu démarrer ; vous voyez donc une image fixe.', 'La figura no pudo iniciarse; por eso ve una imagen fija.',
    'La figura non si è avviata: per questo si vede un’immagine fissa.', '図を開始できなかったため、静止画を表示しています。'],
  lost: ['The browser stopped the drawing. Click the figure to start it again.', 'Der Browser hat das Zeichnen abgebrochen. Klicken Sie auf das Bild, um es neu zu starten.',
    'Le navigateur a interrompu le dessin. Cliquez sur la figure pour la redémarrer.', 'El navegador interrumpió el dibujo. Haga clic en la figura para reiniciarla.',
    'Il browser ha interrotto il disegno. Fate clic sulla figura per riavviarla.', '描画が中断しました。図をクリックすると再開します。'],
  key_play: ['play, pause, go on', 'abspielen, anhalten, weiter', 'lecture, pause, continuer', 'reproducir, pausar, continuar', 'riproduci, pausa, continua', '再生・一時停止・続ける'],
  key_frame: ['one frame', 'ein Einzelbild', 'une image', 'un fotograma', 'un fotogramma', '1 コマ'],
  key_stop: ['previous, next stop or chapter', 'voriger, nächster Halt oder Abschnitt', 'arrêt ou chapitre précédent, suivant', 'parada o capítulo anterior, siguiente', 'sosta o capitolo precedente, successivo', '前・次の停止点か章'],
  key_ends: ['beginning, end', 'Anfang, Ende', 'début, fin', 'principio, fin', 'inizio, fine', '最初・最後'],
  key_digits: ['chapter of that number', 'Abschnitt dieser Nummer', 'chapitre de ce numéro', 'capítulo de ese número', 'capitolo di quel numero', 'その番号の章'],
  key_speed: ['slower, faster', 'langsamer, schneller', 'plus lent, plus rapide', 'más lento, más rápido', 'più lento, più veloce', '遅く・速く'],
  key_turn: ['turn the view', 'Ansicht drehen', 'tourner la vue', 'girar la vista', 'ruotare la vista', '視点を回す'],
  key_pan: ['move the view', 'Ansicht verschieben', 'déplacer la vue', 'desplazar la vista', 'spostare la vista', '視点を動かす'],
  key_zoom: ['nearer, farther', 'näher, weiter', 'plus près, plus loin', 'más cerca, más lejos', 'più vicino, più lontano', '近く・遠く'],
  drag_omega: ['Drag the tip of ω to choose another polhode.', 'Ziehen Sie die Spitze von ω, um eine andere Polhodie zu wählen.',
    'Tirez la pointe de ω pour choisir une autre polhodie.', 'Arrastre la punta de ω para elegir otra polodia.',
    'Trascinate la punta di ω per scegliere un’altra polodia.', 'ω の先を引くと別のポルホードを選べます。'],
  drag_plane: ['Drag the point where L meets the plane to choose another polhode.', 'Ziehen Sie den Punkt, an dem L die Ebene trifft, um eine andere Polhodie zu wählen.',
    'Tirez le point où L rencontre le plan pour choisir une autre polhodie.', 'Arrastre el punto donde L corta el plano para elegir otra polodia.',
    'Trascinate il punto in cui L incontra il piano per scegliere un’altra polodia.', 'L と平面の交点を引くと別のポルホードを選べます。'],
};

/** Names of elements and overlays. @type {Record<string, string[]>} */
export const element_words = {
  plane: ['invariable plane', 'invariable Ebene', 'plan invariable', 'plano invariable', 'piano invariabile', '不変平面'],
  tangent: ['tangent plane', 'Tangentialebene', 'plan tangent', 'plano tangente', 'piano tangente', '接平面'],
  ellipsoid: ['inertia ellipsoid', 'Trägheits­ellipsoid', 'ellipsoïde d’inertie', 'elipsoide de inercia', 'ellissoide d’inerzia', '慣性楕円体'],
  body: ['body', 'Körper', 'corps', 'cuerpo', 'corpo', '物体'],
  'body-beside': ['body beside', 'Körper daneben', 'corps à côté', 'cuerpo al lado', 'corpo accanto', '横の物体'],
  annulus: ['ring of the herpolhode', 'Ring der Herpolhodie', 'anneau de l’herpolhodie', 'anillo de la herpolodia', 'anello dell’erpolodia', 'ハーポルホードの環'],
  polhode: ['polhode', 'Polhodie', 'polhodie', 'polodia', 'polodia', 'ポルホード'],
  herpolhode: ['herpolhode', 'Herpolhodie', 'herpolhodie', 'herpolodia', 'erpolodia', 'ハーポルホード'],
  cones: ['cones', 'Polkegel', 'cônes', 'conos', 'coni', '円錐'],
  'spin-axis': ['axis of rotation', 'Drehachse', 'axe de rotation', 'eje de rotación', 'asse di rotazione', '回転軸'],
  momentum: ['angular momentum L', 'Drehimpuls L', 'moment cinétique L', 'momento angular L', 'momento angolare L', '角運動量 L'],
  omega: ['angular velocity ω', 'Winkel­geschwindigkeit ω', 'vitesse angulaire ω', 'velocidad angular ω', 'velocità angolare ω', '角速度 ω'],
  axes: ['principal axes', 'Hauptachsen', 'axes principaux', 'ejes principales', 'assi principali', '慣性主軸'],
  'given-axes': ['given axes', 'gegebene Achsen', 'axes donnés', 'ejes dados', 'assi dati', '与えられた軸'],
  turn: ['turn to the principal axes', 'Drehung zu den Hauptachsen', 'rotation vers les axes principaux', 'giro a los ejes principales', 'rotazione agli assi principali', '主軸への回転'],
  'half-axes': ['half-axes', 'Halbachsen', 'demi-axes', 'semiejes', 'semiassi', '半軸'],
  'direction-trace': ['path of ρ', 'Spur von ρ', 'trajet de ρ', 'trayecto de ρ', 'percorso di ρ', 'ρ の軌跡'],
  'spin-direction': ['n along ω', 'n entlang ω', 'n selon ω', 'n según ω', 'n lungo ω', 'ω 方向の n'],
  direction: ['direction n', 'Richtung n', 'direction n', 'dirección n', 'direzione n', '方向 n'],
  radius: ['radius vector ρ', 'Ortsvektor ρ', 'rayon vecteur ρ', 'radio vector ρ', 'raggio vettore ρ', '動径 ρ'],
  gradient: ['gradient ∇F', 'Gradient ∇F', 'gradient ∇F', 'gradiente ∇F', 'gradiente ∇F', '勾配 ∇F'],
  projection: ['projection of ρ on L', 'Projektion von ρ auf L', 'projection de ρ sur L', 'proyección de ρ sobre L', 'proiezione di ρ su L', 'ρ の L への射影'],
  distance: ['distance of the plane', 'Abstand der Ebene', 'distance du plan', 'distancia del plano', 'distanza del piano', '平面までの距離'],
  levels: ['marks along L', 'Marken auf L', 'repères sur L', 'marcas sobre L', 'tacche su L', 'L 上の目盛り'],
  velocity: ['velocity', 'Geschwindigkeit', 'vitesse', 'velocidad', 'velocità', '速度'],
  precession: ['precession', 'Präzession', 'précession', 'precesión', 'precessione', '歳差運動'],
  contact: ['contact point', 'Berührpunkt', 'point de contact', 'punto de contacto', 'punto di contatto', '接触点'],
  ghost: ['second method', 'zweites Verfahren', 'seconde méthode', 'segundo método', 'secondo metodo', '第二の解法'],
  measured: ['measured points', 'Messpunkte', 'points mesurés', 'puntos medidos', 'punti misurati', '測定点'],
  'inertial-forces': ['inertial forces', 'Trägheitskräfte', 'forces d’inertie', 'fuerzas de inercia', 'forze d’inerzia', '慣性力'],
  'solid-angle': ['solid angle', 'Raumwinkel', 'angle solide', 'ángulo sólido', 'angolo solido', '立体角'],
  'period-turn': ['turn in one period', 'Drehung in einer Periode', 'rotation en une période', 'giro en un período', 'rotazione in un periodo', '1周期の回転'],
  drift: ['path of the second method', 'Spur des zweiten Verfahrens', 'trajet de la seconde méthode', 'trayecto del segundo método', 'percorso del secondo metodo', '第二の解法の軌跡'],
  title: ['title', 'Titel', 'titre', 'título', 'titolo', 'タイトル'],
  chapter: ['chapter', 'Abschnitt', 'chapitre', 'capítulo', 'capitolo', '章'],
  caption: ['caption', 'Legende', 'légende', 'leyenda', 'didascalia', '説明文'],
  clock: ['clock', 'Uhr', 'horloge', 'reloj', 'orologio', '時計'],
};

/** Labels of keys of the scene that viewers may change. @type {Record<string, string[]>} */
export const key_words = {
  'start.omega_rad_s': ['Angular velocity ω at t = 0', 'Winkelgeschwindigkeit ω bei t = 0', 'Vitesse angulaire ω à t = 0', 'Velocidad angular ω en t = 0', 'Velocità angolare ω a t = 0', 't = 0 での角速度 ω'],
  'start.energy_J': ['Kinetic energy T', 'Kinetische Energie T', 'Énergie cinétique T', 'Energía cinética T', 'Energia cinetica T', '運動エネルギー T'],
  'start.momentum_kg_m2_s': ['Angular momentum |L|', 'Drehimpuls |L|', 'Moment cinétique |L|', 'Momento angular |L|', 'Momento angolare |L|', '角運動量 |L|'],
  'start.plane_distance': ['Distance of the plane', 'Abstand der Ebene', 'Distance du plan', 'Distancia del plano', 'Distanza del piano', '平面までの距離'],
  'start.attitude': ['Attitude at t = 0', 'Lage bei t = 0', 'Orientation à t = 0', 'Orientación en t = 0', 'Assetto a t = 0', 't = 0 での姿勢'],
  'start.attitude_matrix': ['Attitude at t = 0 as a matrix', 'Lage bei t = 0 als Matrix', 'Orientation à t = 0 en matrice', 'Orientación en t = 0 como matriz', 'Assetto a t = 0 come matrice', 't = 0 での姿勢（行列）'],
  'start.theta_rad': ['Tilt θ', 'Neigung θ', 'Inclinaison θ', 'Inclinación θ', 'Inclinazione θ', '傾き θ'],
  'start.theta_dot_rad_s': ['Rate of the tilt', 'Änderung der Neigung', 'Vitesse de l’inclinaison', 'Velocidad de la inclinación', 'Velocità dell’inclinazione', '傾きの速さ'],
  'start.phi_dot_rad_s': ['Rate of precession', 'Präzessionsgeschwindigkeit', 'Vitesse de précession', 'Velocidad de precesión', 'Velocità di precessione', '歳差の速さ'],
  'start.omega3_rad_s': ['Spin ω₃', 'Eigendrehung ω₃', 'Rotation propre ω₃', 'Rotación propia ω₃', 'Rotazione propria ω₃', '自転 ω₃'],
  'body.moments_kg_m2': ['Principal moments of inertia', 'Hauptträgheitsmomente', 'Moments principaux d’inertie', 'Momentos principales de inercia', 'Momenti principali d’inerzia', '主慣性モーメント'],
  'body.tensor_kg_m2': ['Inertia tensor', 'Trägheitstensor', 'Tenseur d’inertie', 'Tensor de inercia', 'Tensore d’inerzia', '慣性テンソル'],
  'body.shape': ['Solid', 'Körper', 'Solide', 'Sólido', 'Solido', '立体'],
  'body.object': ['Body', 'Körper', 'Corps', 'Cuerpo', 'Corpo', '物体'],
  'body.size_m': ['Dimensions', 'Abmessungen', 'Dimensions', 'Dimensiones', 'Dimensioni', '寸法'],
  'body.mass_kg': ['Mass', 'Masse', 'Masse', 'Masa', 'Massa', '質量'],
  'body.density_kg_m3': ['Density', 'Dichte', 'Masse volumique', 'Densidad', 'Densità', '密度'],
  'body.mesh': ['Surface from a file', 'Oberfläche aus einer Datei', 'Surface d’un fichier', 'Superficie de un archivo', 'Superficie da un file', 'ファイルの表面'],
  'body.scale': ['Scale', 'Maßstab', 'Échelle', 'Escala', 'Scala', '縮尺'],
  'body.allow_unphysical': ['Allow moments that no body has', 'Momente zulassen, die kein Körper hat', 'Admettre des moments qu’aucun corps n’a', 'Permitir momentos que ningún cuerpo tiene', 'Ammettere momenti che nessun corpo ha', '実在しない慣性モーメントを許す'],
  'body.masses.mass_kg': ['Mass of the point', 'Masse des Punktes', 'Masse du point', 'Masa del punto', 'Massa del punto', '質点の質量'],
  'body.masses.at_m': ['Position of the point', 'Ort des Punktes', 'Position du point', 'Posición del punto', 'Posizione del punto', '質点の位置'],
  'torque.mgl_N_m': ['Weight times distance mgl', 'Gewicht mal Abstand mgl', 'Poids fois distance mgl', 'Peso por distancia mgl', 'Peso per distanza mgl', '重さ × 距離 mgl'],
  'torque.torque_body_N_m': ['Torque in body axes', 'Drehmoment in Körperachsen', 'Couple dans les axes du corps', 'Par en los ejes del cuerpo', 'Coppia negli assi del corpo', '物体軸でのトルク'],
  'torque.torque_space_N_m': ['Torque in space axes', 'Drehmoment in Raumachsen', 'Couple dans les axes fixes', 'Par en los ejes fijos', 'Coppia negli assi fissi', '空間軸でのトルク'],
  'torque.kind': ['Torque', 'Drehmoment', 'Couple', 'Par', 'Coppia', 'トルク'],
  'torque.arm_body': ['Direction of the centre of mass', 'Richtung zum Schwerpunkt', 'Direction du centre de masse', 'Dirección del centro de masas', 'Direzione del centro di massa', '重心の方向'],
  'torque.rate_1_s': ['Rate of internal friction', 'Rate der inneren Reibung', 'Taux de frottement interne', 'Tasa de fricción interna', 'Tasso di attrito interno', '内部摩擦の速さ'],
  'torque.linear_1_s': ['Linear drag of the air', 'Linearer Luftwiderstand', 'Traînée linéaire de l’air', 'Resistencia lineal del aire', 'Resistenza lineare dell’aria', '空気抵抗（1次）'],
  'torque.quadratic_1_rad': ['Quadratic drag of the air', 'Quadratischer Luftwiderstand', 'Traînée quadratique de l’air', 'Resistencia cuadrática del aire', 'Resistenza quadratica dell’aria', '空気抵抗（2次）'],
  'torque.growth_1_s': ['Growth of the drag', 'Wachstum des Luftwiderstands', 'Croissance de la traînée', 'Crecimiento de la resistencia', 'Crescita della resistenza', '空気抵抗の増加'],
  'torque.half_life_s': ['Half-life of the energy', 'Halbwertszeit der Energie', 'Demi-vie de l’énergie', 'Semivida de la energía', 'Emivita dell’energia', 'エネルギーの半減期'],
  'motion.method': ['Method', 'Verfahren', 'Méthode', 'Método', 'Metodo', '解法'],
  'motion.step_s': ['Time step', 'Zeitschritt', 'Pas de temps', 'Paso de tiempo', 'Passo temporale', '時間刻み'],
  'motion.tolerance': ['Tolerance', 'Toleranz', 'Tolérance', 'Tolerancia', 'Tolleranza', '許容誤差'],
  'motion.order': ['Order of the method', 'Ordnung des Verfahrens', 'Ordre de la méthode', 'Orden del método', 'Ordine del metodo', '解法の次数'],
  'beside.method': ['Second method', 'Zweites Verfahren', 'Seconde méthode', 'Segundo método', 'Secondo metodo', '第二の解法'],
  'beside.step_s': ['Time step of the second method', 'Zeitschritt des zweiten Verfahrens', 'Pas de la seconde méthode', 'Paso del segundo método', 'Passo del secondo metodo', '第二の解法の時間刻み'],
  'beside.tolerance': ['Tolerance of the second method', 'Toleranz des zweiten Verfahrens', 'Tolérance de la seconde méthode', 'Tolerancia del segundo método', 'Tolleranza del secondo metodo', '第二の解法の許容誤差'],
  'beside.order': ['Order of the second method', 'Ordnung des zweiten Verfahrens', 'Ordre de la seconde méthode', 'Orden del segundo método', 'Ordine del secondo metodo', '第二の解法の次数'],
  'construction.plane': ['Place of the plane', 'Lage der Ebene', 'Place du plan', 'Lugar del plano', 'Posto del piano', '平面の位置'],
  'construction.sweep': ['Swept quantity', 'Durchlaufene Größe', 'Grandeur balayée', 'Magnitud recorrida', 'Grandezza percorsa', '掃引する量'],
  'film.speed': ['Speed of the film', 'Tempo des Films', 'Vitesse du film', 'Velocidad de la película', 'Velocità del film', '映像の速さ'],
};

/** The words in one language. */
export class Words {
  /** @param {string} code */
  constructor(code) {
    this.code = languages.includes(code) ? code : 'en';
  }
  /** @param {string} name @returns {string} */
  of(name) {
    const row = all_words[name];
    return row?.[languages.indexOf(this.code)] ?? name;
  }
  /** The name of an element or overlay. @param {string} name */
  element(name) {
    return element_words[name]?.[languages.indexOf(this.code)] ?? name.replaceAll('-', ' ');
  }
  /** The label of a key of the scene, without its index; undefined: there is none. @param {string} key */
  label(key) {
    return key_words[key.replace(/\[\d+\]/g, '')]?.[languages.indexOf(this.code)];
  }
}

/** What a body does that moves freely or turns over, in words that need no theory; '' of any other motion. @param {Loaded} loaded @param {Words} words */
export function motion_said({flips, polhode_axis}, words) {
  const seconds = (/** @type {number} */ s) => s.toLocaleString(words.code, {maximumSignificantDigits: 3});
  if (flips?.times_s && flips.times_s.length > 1) return words.of('turns_over_at').replace('{s}', flips.times_s.slice(0, 4).map(seconds).join('; ') + (flips.times_s.length > 4 ? '; …' : ''));
  if (flips) return flips.interval_s === null ? words.of('turns_over_once').replace('{s}', seconds(flips.one_s))
    : words.of('turns_over').replace('{s}', seconds(flips.interval_s));
  return polhode_axis ? words.of(`wobbles_${polhode_axis}`) : '';
}
